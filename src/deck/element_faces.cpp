#include "element_faces.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

namespace creepcontact::deck {

mesh::CellType element_cell(const Deck& deck, std::int64_t element) {
  return deck.elements[deck.element_of_number.at(element).block].type.cell;
}

std::span<const std::int64_t> element_nodes(const Deck& deck, std::int64_t element) {
  const Deck::ElementPlace place = deck.element_of_number.at(element);
  const ElementBlock& block = deck.elements[place.block];
  const auto n = static_cast<std::size_t>(mesh::n_nodes(block.type.cell));
  return {block.nodes.data() + place.element * n, n};
}

std::span<std::int64_t> element_nodes(Deck& deck, std::int64_t element) {
  const Deck::ElementPlace place = deck.element_of_number.at(element);
  ElementBlock& block = deck.elements[place.block];
  const auto n = static_cast<std::size_t>(mesh::n_nodes(block.type.cell));
  return {block.nodes.data() + place.element * n, n};
}

Numbers face_nodes(const Deck& deck, const ElementFace& face) {
  const std::span<const std::int64_t> nodes = element_nodes(deck, face.element);
  Numbers result;
  for (const int place : *deck::face(element_cell(deck, face.element), face.face))
    result.push_back(nodes[static_cast<std::size_t>(place)]);
  return result;
}

Numbers face_corners(const Deck& deck, const ElementFace& face) {
  Numbers result = face_nodes(deck, face);
  const mesh::CellType cell = element_cell(deck, face.element);
  if (mesh::dimension(cell) == 2)
    result.resize(2);
  else if (mesh::order(cell) == 2)
    result.resize(result.size() / 2);
  std::ranges::sort(result);
  return result;
}

mesh::CellType face_cell(mesh::CellType element, std::size_t n_nodes) {
  using mesh::CellType;
  if (mesh::dimension(element) == 2) return n_nodes == 2 ? CellType::line2 : CellType::line3;
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

Vector3 outward_area(const Deck& deck, const ElementFace& face) {
  const auto position = [&](std::int64_t node) { return deck.positions[deck.node_of_number.at(node)]; };
  const Numbers corners = face_nodes(deck, face);
  const std::span<const std::int64_t> all = element_nodes(deck, face.element);
  Vector3 centre = Vector3::Zero(), middle = Vector3::Zero();
  for (const std::int64_t node : all) centre += position(node) / static_cast<double>(all.size());
  for (const std::int64_t node : corners) middle += position(node) / static_cast<double>(corners.size());
  const Vector3 a = position(corners[1]) - position(corners[0]);
  const bool is_edge = mesh::dimension(element_cell(deck, face.element)) == 2;
  const Vector3 across = is_edge ? Vector3(Vector3::UnitZ()) : Vector3(position(corners[2]) - position(corners[0]));
  const Vector3 area = a.cross(across);
  return area.dot(middle - centre) < 0 ? Vector3(-area) : area;
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
    if (!entry.side.empty()) {
      refuse(entry, fmt::format("{}: a side of a gasket, which only *TIE and *CONTACT PAIR can name, or of a shell; "
                                "shells are not known",
                                entry.side));
      continue;
    }
    const Numbers elements = resolver.elements(entry.target);
    if (elements.empty()) refuse(entry, fmt::format("there is no element or set '{}'", entry.target));
    for (const std::int64_t number : elements) {
      if (entry.face == 0) {
        refuse(entry, "a surface without faces (S1, S2, ...)");
        break;
      }
      if (face(element_cell(deck, number), entry.face) == nullptr) {
        refuse(entry, fmt::format("element {} has no face S{}", number, entry.face));
        break;
      }
      faces.insert({number, entry.face});
    }
  }
  if (!surface.of_nodes) return {faces.begin(), faces.end()};
  // Faces of one element alone, all corners of which are among the nodes.
  std::map<Numbers, std::vector<ElementFace>> candidates;
  for (const ElementBlock& block : deck.elements)
    for (const std::int64_t number : block.numbers) {
      if (std::ranges::none_of(element_nodes(deck, number), [&](std::int64_t node) { return nodes.contains(node); }))
        continue;
      for (int k = 1; face(block.type.cell, k) != nullptr; ++k) {
        const Numbers own = face_corners(deck, {number, k});
        if (std::ranges::all_of(own, [&](std::int64_t node) { return nodes.contains(node); }))
          candidates[own].push_back({number, k});
      }
    }
  for (const auto& [own, found] : candidates)
    if (found.size() == 1) faces.insert(found.front());
  return {faces.begin(), faces.end()};
}

std::vector<ElementFace> faces_named(const Deck& deck, const std::string& name, std::vector<Note>& impossible) {
  const auto surface = deck.surfaces.find(upper_case(name));
  if (surface != deck.surfaces.end()) return faces_of(deck, surface->second, impossible);
  return deck.node_sets.contains(upper_case(name)) ? faces_of(deck, {name, true, {{name, 0, {}}}}, impossible)
                                                   : std::vector<ElementFace>();
}

}  // namespace creepcontact::deck
