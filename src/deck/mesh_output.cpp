#include "mesh_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <span>

#include "creepcontact/io/msh_writer.hpp"

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

/// Of a face with this number of nodes.
CellType face_type(CellType cell, std::size_t n_nodes) {
  if (mesh::dimension(cell) == 2) return n_nodes == 2 ? CellType::line2 : CellType::line3;
  switch (n_nodes) {
    case 3:
      return CellType::tri3;
    case 4:
      return CellType::quad4;
    case 6:
      return CellType::tri6;
    default:
      return CellType::quad8;
  }
}

struct Found {
  CellType cell{};
  std::span<const std::int64_t> nodes;
};

Found element(const Deck& deck, std::int64_t number) {
  const Deck::ElementPlace place = deck.element_of_number.at(number);
  const ElementBlock& block = deck.elements[place.block];
  const auto n = static_cast<std::size_t>(mesh::n_nodes(block.type.cell));
  return {block.type.cell, {block.nodes.data() + place.element * n, n}};
}

/// Numbers of the nodes at these places of an element.
std::vector<std::uint64_t> at_places(const Found& element, const std::vector<int>& places) {
  std::vector<std::uint64_t> nodes;
  nodes.reserve(places.size());
  for (const int place : places)
    nodes.push_back(static_cast<std::uint64_t>(element.nodes[static_cast<std::size_t>(place)]));
  return nodes;
}

/// Corners of a face, sorted.
Numbers corners(const Deck& deck, const ElementFace& face) {
  const Found own = element(deck, face.element);
  const std::vector<int>& places = *deck::face(own.cell, face.face);
  const std::size_t n_corners = mesh::order(own.cell) == 2
                                    ? (places.size() == 3 && mesh::dimension(own.cell) == 2 ? 2 : places.size() / 2)
                                    : places.size();
  Numbers result;
  for (std::size_t i = 0; i < n_corners; ++i) result.push_back(own.nodes[static_cast<std::size_t>(places[i])]);
  std::ranges::sort(result);
  return result;
}

}  // namespace

MeshOutput::MeshOutput(const Deck& deck) : deck_(deck) {
  for (std::size_t i = 0; i < deck.positions.size(); ++i) {
    content_.node_tags.push_back(static_cast<std::uint64_t>(deck.node_numbers[i]));
    content_.nodes.push_back(deck.positions[i]);
  }
}

std::string MeshOutput::free_name(const std::string& wanted) {
  std::string name = wanted;
  std::ranges::replace(name, '"', '_');
  for (int i = 2; names_.contains(name); ++i) name = fmt::format("{}_{}", wanted, i);
  names_[name] = 1;
  return name;
}

void MeshOutput::add_group(const std::string& name, const std::map<CellType, std::vector<CellNodes>>& cells) {
  const io::MshContent::Key key{mesh::dimension(cells.begin()->first), static_cast<int>(content_.physicals.size()) + 1};
  content_.physical_names[key] = name;
  content_.physicals[key] = {key.tag};
  for (const auto& [type, of_type] : cells) {
    io::MshContent::Elements& into =
        content_.elements.emplace_back(io::MshContent::Elements{key, gmsh_type(type), {}, {}});
    for (const CellNodes& nodes : of_type) {
      into.tags.push_back(next_tag_++);
      into.nodes.insert(into.nodes.end(), nodes.begin(), nodes.end());
    }
  }
}

std::string MeshOutput::add_body(const DeckBody& body) {
  std::string name = free_name(body.name);
  std::map<CellType, std::vector<CellNodes>> cells;
  for (const std::int64_t number : body.elements) {
    const Found own = element(deck_, number);
    cells[own.cell].push_back(at_places(own, gmsh_order(own.cell)));
  }
  add_group(name, cells);
  return name;
}

std::string MeshOutput::add_nodes(const std::string& wanted, const Numbers& nodes) {
  std::string name = free_name(wanted);
  std::vector<CellNodes> points;
  points.reserve(nodes.size());
  for (const std::int64_t node : nodes) points.push_back({static_cast<std::uint64_t>(node)});
  add_group(name, {{CellType::point1, std::move(points)}});
  return name;
}

std::string MeshOutput::add_faces(const std::string& wanted, const std::vector<ElementFace>& faces) {
  std::string name = free_name(wanted);
  std::map<CellType, std::vector<CellNodes>> cells;
  for (const ElementFace& face : faces) {
    const Found own = element(deck_, face.element);
    const std::vector<int>& places = *deck::face(own.cell, face.face);
    cells[face_type(own.cell, places.size())].push_back(at_places(own, places));
  }
  add_group(name, cells);
  return name;
}

std::string MeshOutput::msh() const {
  return io::write_msh(content_);
}

std::vector<ElementFace> faces_of(const Deck& deck, const Surface& surface, std::vector<Note>& impossible) {
  const Resolver resolver(deck);
  std::set<ElementFace> faces;
  const auto refuse = [&](const SurfaceEntry& entry, const std::string& why) {
    impossible.push_back({entry.place, "SURFACE", why});
  };
  std::set<std::int64_t> nodes;
  for (const SurfaceEntry& entry : surface.entries) {
    if (surface.of_nodes) {
      const Numbers found = resolver.nodes(entry.target);
      if (found.empty()) refuse(entry, fmt::format("there is no node or set '{}'", entry.target));
      nodes.insert(found.begin(), found.end());
      continue;
    }
    const Numbers elements = resolver.elements(entry.target);
    if (elements.empty()) refuse(entry, fmt::format("there is no element or set '{}'", entry.target));
    for (const std::int64_t number : elements) {
      if (entry.face == 0) {
        refuse(entry, "a surface without faces (S1, S2, ...)");
        break;
      }
      if (face(element(deck, number).cell, entry.face) == nullptr) {
        refuse(entry, fmt::format("element {} has no face S{}", number, entry.face));
        break;
      }
      faces.insert({number, entry.face});
    }
  }
  if (!surface.of_nodes) return {faces.begin(), faces.end()};
  // Faces of one element alone, all corners of which are among the nodes.
  std::map<Numbers, std::vector<ElementFace>> candidates;
  for (const auto& [number, place] : deck.element_of_number) {
    const CellType cell = deck.elements[place.block].type.cell;
    for (int k = 1; face(cell, k) != nullptr; ++k) {
      const Numbers own = corners(deck, {number, k});
      if (std::ranges::all_of(own, [&](std::int64_t node) { return nodes.contains(node); }))
        candidates[own].push_back({number, k});
    }
  }
  for (const auto& [own, found] : candidates)
    if (found.size() == 1) faces.insert(found.front());
  return {faces.begin(), faces.end()};
}

}  // namespace creepcontact::deck
