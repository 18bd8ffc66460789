#include "contact_adjustment.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "element_faces.hpp"

namespace creepcontact::deck {
namespace {

/// Edges from a node that has moved to one that has not become straight: contact is between corners, and the bend of
/// such an edge would be read as an overlap.
void straighten(Deck& deck, const std::vector<ElementFace>& slave, const std::map<std::int64_t, NearestPoint>& moved) {
  const auto position = [&](std::int64_t node) -> Vector3& { return deck.positions[deck.node_of_number.at(node)]; };
  for (const ElementFace& face : slave) {
    const mesh::CellType cell = element_cell(deck, face.element);
    if (mesh::order(cell) == 1) continue;
    const Numbers nodes = face_nodes(deck, face);  // corners, then the nodes between them
    const bool is_edge = mesh::dimension(cell) == 2;
    const std::size_t n = is_edge ? 2 : nodes.size() / 2;
    for (std::size_t i = 0; i < nodes.size() - n; ++i) {
      const std::int64_t a = nodes[i], b = nodes[(i + 1) % n], middle = nodes[n + i];
      if (moved.contains(a) != moved.contains(b) && !moved.contains(middle))
        position(middle) = (position(a) + position(b)) / 2;
    }
  }
}

}  // namespace

std::optional<Reach> adjust_reach(const Deck& deck, const std::string& adjust, const std::vector<ElementFace>& slave,
                                  const std::vector<ElementFace>& master, std::string& problem) {
  constexpr double rounding = 1e-9;  // of the size of the surface
  if (slave.empty() || master.empty()) return std::nullopt;
  const std::optional<double> distance = number(adjust);
  const Numbers members = distance ? Numbers() : Resolver(deck).nodes(adjust);
  if (!distance && members.empty()) {
    problem = fmt::format("ADJUST: '{}' is not a distance or a node set", adjust);
    return std::nullopt;
  }
  const std::map<std::int64_t, NearestPoint> all = nearest_points(deck, slave, master);
  Eigen::AlignedBox3d box;
  for (const auto& [node, nearest] : all) box.extend(deck.positions[deck.node_of_number.at(node)]);
  const double limit = distance.value_or(0) + rounding * box.diagonal().norm();
  Reach result{{}, all.size()};
  for (const auto& [node, nearest] : all)
    if (distance ? nearest.distance <= limit : std::ranges::binary_search(members, node))
      result.near.emplace(node, nearest);
  return result;
}

void adjust_contacts(Deck& deck) {
  std::vector<Note> unused;  // what is wrong is reported where the contacts are made
  std::string problem;
  for (const RawCard& raw : deck.cards) {
    if (raw.card.name != "CONTACT PAIR" || !raw.card.has("ADJUST") || raw.card.has("TIED")) continue;
    for (const std::vector<std::string>& line : raw.data) {
      if (line.size() < 2) continue;
      const std::vector<ElementFace> slave = faces_named(deck, line[0], unused);
      const auto reach =
          adjust_reach(deck, raw.card.value("ADJUST"), slave, faces_named(deck, line[1], unused), problem);
      if (!reach || reach->all_near()) continue;
      for (const auto& [node, nearest] : reach->near) deck.positions[deck.node_of_number.at(node)] = nearest.position;
      straighten(deck, slave, reach->near);
    }
  }
}

}  // namespace creepcontact::deck
