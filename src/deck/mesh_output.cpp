#include "mesh_output.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "creepcontact/io/msh_writer.hpp"
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

/// Numbers of the nodes at these places of an element.
std::vector<std::uint64_t> at_places(std::span<const std::int64_t> nodes, const std::vector<int>& places) {
  std::vector<std::uint64_t> result;
  result.reserve(places.size());
  for (const int place : places) result.push_back(static_cast<std::uint64_t>(nodes[static_cast<std::size_t>(place)]));
  return result;
}

}  // namespace

MeshOutput::MeshOutput(const Deck& deck) : deck_(deck) {
  for (std::size_t i = 0; i < deck.positions.size(); ++i) {
    content_.node_tags.push_back(static_cast<std::uint64_t>(deck.node_numbers[i]));
    content_.nodes.push_back(deck.positions[i]);
  }
  for (const ElementBlock& block : deck.elements)
    for (const std::int64_t number : block.numbers)
      next_number_ = std::max(next_number_, static_cast<std::uint64_t>(number) + 1);
}

std::string MeshOutput::free_name(const std::string& wanted) {
  std::string name = wanted;
  std::ranges::replace(name, '"', '_');
  for (int i = 2; names_.contains(name); ++i) name = fmt::format("{}_{}", wanted, i);
  names_[name] = 1;
  return name;
}

void MeshOutput::add_group(const std::string& name, const std::map<CellType, std::vector<Cell>>& cells) {
  const io::MshContent::Key key{mesh::dimension(cells.begin()->first), static_cast<int>(content_.physicals.size()) + 1};
  content_.physical_names[key] = name;
  content_.physicals[key] = {key.tag};
  for (const auto& [type, of_type] : cells) {
    io::MshContent::Elements& into =
        content_.elements.emplace_back(io::MshContent::Elements{key, gmsh_type(type), {}, {}});
    for (const Cell& cell : of_type) {
      into.tags.push_back(cell.number);
      into.nodes.insert(into.nodes.end(), cell.nodes.begin(), cell.nodes.end());
    }
  }
}

std::string MeshOutput::add_body(const DeckBody& body) {
  std::string name = free_name(body.name);
  std::map<CellType, std::vector<Cell>> cells;
  for (const std::int64_t number : body.elements) {
    const CellType type = element_cell(deck_, number);
    cells[type].push_back(
        {static_cast<std::uint64_t>(number), at_places(element_nodes(deck_, number), gmsh_order(type))});
  }
  add_group(name, cells);
  return name;
}

std::string MeshOutput::add_nodes(const std::string& wanted, const Numbers& nodes) {
  if (const auto known = of_nodes_.find(nodes); known != of_nodes_.end()) return known->second;
  std::string name = free_name(wanted);
  std::vector<Cell> points;
  points.reserve(nodes.size());
  for (const std::int64_t node : nodes) points.push_back({next_number_++, {static_cast<std::uint64_t>(node)}});
  add_group(name, {{CellType::point1, std::move(points)}});
  return of_nodes_[nodes] = name;
}

std::string MeshOutput::add_faces(const std::string& wanted, const std::vector<ElementFace>& faces) {
  std::string name = free_name(wanted);
  std::map<CellType, std::vector<Cell>> cells;
  for (const ElementFace& face : faces) {
    const CellType type = element_cell(deck_, face.element);
    const std::vector<int>& places = *deck::face(type, face.face);
    cells[face_cell(type, places.size())].push_back(
        {next_number_++, at_places(element_nodes(deck_, face.element), places)});
  }
  add_group(name, cells);
  return name;
}

std::string MeshOutput::msh() const {
  return io::write_msh(content_);
}

}  // namespace creepcontact::deck
