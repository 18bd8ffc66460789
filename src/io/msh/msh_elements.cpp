#include "msh_elements.hpp"

#include <map>
#include <utility>
#include <vector>

namespace creepcontact::io {
namespace {

using mesh::CellType;

struct Family {
  const char* name;
  int dimension;
  std::vector<std::pair<int, int>> sizes;  // type, number of nodes
};

/// Everything that Gmsh 4 writes with a fixed number of nodes, so that elements outside the groups can be skipped.
const std::vector<Family>& families() {
  static const std::vector<Family> all{
      {"Point", 0, {{15, 1}}},
      {"Line", 1, {{84, 1}, {1, 2}, {8, 3}, {26, 4}, {27, 5}, {28, 6}, {62, 7}, {63, 8}, {64, 9}, {65, 10}, {66, 11}}},
      {"Triangle",
       2,
       {{85, 1},
        {2, 3},
        {9, 6},
        {20, 9},
        {21, 10},
        {22, 12},
        {23, 15},
        {24, 15},
        {25, 21},
        {42, 28},
        {43, 36},
        {44, 45},
        {45, 55},
        {46, 66},
        {52, 18},
        {53, 21},
        {54, 24},
        {55, 27},
        {56, 30}}},
      {"Quadrilateral", 2, {{86, 1},   {3, 4},   {16, 8},  {10, 9},  {36, 16}, {37, 25}, {38, 36},
                            {39, 12},  {40, 16}, {41, 20}, {47, 49}, {48, 64}, {49, 81}, {50, 100},
                            {51, 121}, {57, 24}, {58, 28}, {59, 32}, {60, 36}, {61, 40}}},
      {"Tetrahedron",
       3,
       {{87, 1},
        {4, 4},
        {11, 10},
        {29, 20},
        {30, 35},
        {31, 56},
        {32, 22},
        {33, 28},
        {71, 84},
        {72, 120},
        {73, 165},
        {74, 220},
        {75, 286},
        {79, 34},
        {80, 40},
        {81, 46},
        {82, 52},
        {83, 58},
        {137, 16}}},
      {"Hexahedron",
       3,
       {{88, 1},
        {5, 8},
        {17, 20},
        {12, 27},
        {92, 64},
        {93, 125},
        {94, 216},
        {95, 343},
        {96, 512},
        {97, 729},
        {98, 1000},
        {99, 32},
        {100, 44},
        {101, 56},
        {102, 68},
        {103, 80},
        {104, 92},
        {105, 104}}},
      {"Prism",
       3,
       {{89, 1},
        {6, 6},
        {18, 15},
        {13, 18},
        {90, 40},
        {91, 75},
        {106, 126},
        {107, 196},
        {108, 288},
        {109, 405},
        {110, 550},
        {111, 24},
        {112, 33},
        {113, 42},
        {114, 51},
        {115, 60},
        {116, 69},
        {117, 78}}},
      {"Pyramid",
       3,
       {{132, 1},
        {7, 5},
        {19, 13},
        {14, 14},
        {118, 30},
        {119, 55},
        {120, 91},
        {121, 140},
        {122, 204},
        {123, 285},
        {124, 385},
        {125, 21},
        {126, 29},
        {127, 37},
        {128, 45},
        {129, 53},
        {130, 61},
        {131, 69}}}};
  return all;
}

const std::map<int, CellType>& supported() {
  static const std::map<int, CellType> types{{15, CellType::point1}, {1, CellType::line2},  {8, CellType::line3},
                                             {2, CellType::tri3},    {9, CellType::tri6},   {3, CellType::quad4},
                                             {16, CellType::quad8},  {10, CellType::quad9}, {4, CellType::tet4},
                                             {11, CellType::tet10},  {5, CellType::hex8},   {17, CellType::hex20},
                                             {12, CellType::hex27},  {6, CellType::wedge6}, {18, CellType::wedge15}};
  return types;
}

std::map<int, MshElement> make_elements() {
  std::map<int, MshElement> elements;
  for (const Family& family : families()) {
    for (const auto& [type, n_nodes] : family.sizes) {
      const auto cell = supported().find(type);
      elements[type] = {family.name, family.dimension, n_nodes,
                        cell == supported().end() ? std::nullopt : std::optional(cell->second)};
    }
  }
  return elements;
}

}  // namespace

std::string MshElement::name() const {
  return dimension == 0 ? family : family + " " + std::to_string(n_nodes);
}

const MshElement* msh_element(int type) {
  static const std::map<int, MshElement> elements = make_elements();
  const auto found = elements.find(type);
  return found == elements.end() ? nullptr : &found->second;
}

}  // namespace creepcontact::io
