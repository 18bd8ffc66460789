#include "mesh_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "element_faces.hpp"

namespace creepcontact::deck {
namespace {

using mesh::CellType;

int gmsh_type(CellType type) {
  static const std::map<CellType, int> types{{CellType::line2, 1},   {CellType::tri3, 2},   {CellType::quad4, 3},
                                             {CellType::tet4, 4},    {CellType::hex8, 5},   {CellType::wedge6, 6},
                                             {CellType::line3, 8},   {CellType::tri6, 9},   {CellType::tet10, 11},
                                             {CellType::point1, 15}, {CellType::quad8, 16}, {CellType::hex20, 17},
                                             {CellType::wedge15, 18}};
  return types.at(type);
}

}  // namespace

MeshOutput::MeshOutput(const Deck& deck) : deck_(deck) {
  content_.node_tags.reserve(deck.positions.size());
  content_.nodes.reserve(deck.positions.size());
  for (std::size_t i = 0; i < deck.positions.size(); ++i) {
    content_.node_tags.push_back(static_cast<std::uint64_t>(deck.node_numbers[i]));
    content_.nodes.push_back(deck.positions[i]);
  }
  for (const ElementBlock& block : deck.elements)
    for (const std::int64_t number : block.numbers)
      next_number_ = std::max(next_number_, static_cast<std::uint64_t>(number) + 1);
}

std::string MeshOutput::free_name(const std::string& wanted) {
  std::string base = wanted;
  std::ranges::replace(base, '"', '_');
  std::string name = base;
  for (int i = 2; names_.contains(name); ++i) name = fmt::format("{}_{}", base, i);
  names_[name] = 1;
  return name;
}

io::MshContent::Key MeshOutput::new_group(int dimension, const std::string& name) {
  const io::MshContent::Key key{dimension, static_cast<int>(content_.physicals.size()) + 1};
  content_.physical_names[key] = name;
  content_.physicals[key] = {key.tag};
  return key;
}

void MeshOutput::add_cell(io::MshContent::Key group, CellType type, std::uint64_t number,
                          std::span<const std::int64_t> nodes, std::span<const int> places) {
  // Blocks of one group follow each other.
  auto block = content_.elements.end();
  while (block != content_.elements.begin() && (block - 1)->entity == group && (block - 1)->type != gmsh_type(type))
    --block;
  const bool is_known = block != content_.elements.begin() && (block - 1)->entity == group;
  io::MshContent::Elements& into =
      is_known ? *(block - 1)
               : content_.elements.emplace_back(io::MshContent::Elements{group, gmsh_type(type), {}, {}});
  into.tags.push_back(number);
  for (const int place : places)
    into.nodes.push_back(static_cast<std::uint64_t>(nodes[static_cast<std::size_t>(place)]));
}

std::string MeshOutput::add_body(const DeckBody& body) {
  std::string name = free_name(body.name);
  const auto group = new_group(mesh::dimension(element_cell(deck_, body.elements.front())), name);
  std::map<CellType, std::size_t> counts;
  for (const std::int64_t number : body.elements) ++counts[element_cell(deck_, number)];
  for (const auto& [type, count] : counts) {
    io::MshContent::Elements& block =
        content_.elements.emplace_back(io::MshContent::Elements{group, gmsh_type(type), {}, {}});
    block.tags.reserve(count);
    block.nodes.reserve(count * static_cast<std::size_t>(mesh::n_nodes(type)));
  }
  for (const std::int64_t number : body.elements) {
    const CellType type = element_cell(deck_, number);
    add_cell(group, type, static_cast<std::uint64_t>(number), element_nodes(deck_, number), gmsh_order(type));
  }
  return name;
}

std::string MeshOutput::add_nodes(const std::string& wanted, const Numbers& nodes) {
  if (const auto known = of_nodes_.find(nodes); known != of_nodes_.end()) return known->second;
  std::string name = free_name(wanted);
  const auto group = new_group(0, name);
  constexpr std::array place{0};
  for (const std::int64_t node : nodes) add_cell(group, CellType::point1, next_number_++, {&node, 1}, place);
  return of_nodes_[nodes] = name;
}

std::string MeshOutput::add_faces(const std::string& wanted, const std::vector<ElementFace>& faces) {
  std::string name = free_name(wanted);
  const auto group = new_group(mesh::dimension(element_cell(deck_, faces.front().element)) - 1, name);
  for (const ElementFace& face : faces) {
    const CellType type = element_cell(deck_, face.element);
    const std::vector<int>& places = *deck::face(type, face.face);
    add_cell(group, face_cell(type, places.size()), next_number_++, element_nodes(deck_, face.element), places);
  }
  return name;
}

std::string MeshOutput::add_skin(const std::string& wanted, const std::vector<Numbers>& faces) {
  static const std::map<std::size_t, CellType> types{
      {3, CellType::tri3}, {4, CellType::quad4}, {6, CellType::tri6}, {8, CellType::quad8}};
  constexpr std::array places{0, 1, 2, 3, 4, 5, 6, 7};
  std::string name = free_name(wanted);
  const auto group = new_group(2, name);
  for (const Numbers& nodes : faces)
    add_cell(group, types.at(nodes.size()), next_number_++, nodes, std::span(places).first(nodes.size()));
  return name;
}

}  // namespace creepcontact::deck
