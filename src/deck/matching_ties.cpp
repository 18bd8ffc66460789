#include "matching_ties.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <set>

#include "creepcontact/mesh/point_tree.hpp"
#include "element_faces.hpp"

namespace creepcontact::deck {
namespace {

constexpr double same_place = 1e-7;  // of the size of the surface

Numbers nodes_of(const Deck& deck, const std::string& name) {
  std::vector<Note> unused;  // what is wrong is reported where the tie is made a contact
  const auto surface = deck.surfaces.find(upper_case(name));
  if (surface == deck.surfaces.end()) return {};
  std::set<std::int64_t> nodes;
  for (const ElementFace& face : faces_of(deck, surface->second, unused)) {
    const Numbers own = face_nodes(deck, face);
    nodes.insert(own.begin(), own.end());
  }
  return {nodes.begin(), nodes.end()};
}

/// Two forces on nodes that become one would not add up.
std::set<std::int64_t> loaded_nodes(const Deck& deck) {
  const Resolver resolver(deck);
  std::set<std::int64_t> nodes;
  for (const Step& step : deck.steps)
    for (const RawCard& raw : step.cards)
      if (raw.card.name == "CLOAD")
        for (const std::vector<std::string>& line : raw.data)
          if (!line.empty())
            for (const std::int64_t node : resolver.nodes(line[0])) nodes.insert(node);
  return nodes;
}

/// Pairs of a slave and a master node; empty if some slave node has no partner.
std::vector<std::pair<std::int64_t, std::int64_t>> partners(const Deck& deck, const Numbers& slave,
                                                            const Numbers& master) {
  std::vector<std::pair<std::int64_t, std::int64_t>> result;
  if (slave.empty() || master.empty()) return result;
  std::vector<Vector3> positions;
  Eigen::AlignedBox3d box;
  const auto position = [&](std::int64_t node) { return deck.positions[deck.node_of_number.at(node)]; };
  for (const std::int64_t node : master) {
    positions.push_back(position(node));
    box.extend(positions.back());
  }
  const mesh::PointTree tree(positions);
  std::set<std::int64_t> taken;
  for (const std::int64_t node : slave) {
    const mesh::Neighbour nearest = tree.nearest(position(node), 1).front();
    const std::int64_t other = master[nearest.point];
    if (nearest.distance > same_place * box.diagonal().norm() || other == node || !taken.insert(other).second)
      return {};
    result.emplace_back(node, other);
  }
  return result;
}

void rename(Deck& deck, const std::vector<std::pair<std::int64_t, std::int64_t>>& pairs) {
  std::unordered_map<std::int64_t, std::int64_t> now(pairs.begin(), pairs.end());
  const auto apply = [&](Numbers& numbers) {
    for (std::int64_t& number : numbers)
      if (const auto found = now.find(number); found != now.end()) number = found->second;
  };
  for (ElementBlock& block : deck.elements) apply(block.nodes);
  for (auto& [name, set] : deck.node_sets) apply(set.members);
  for (auto& [from, to] : deck.same_as)
    if (const auto found = now.find(to); found != now.end()) to = found->second;
  deck.same_as.insert(pairs.begin(), pairs.end());
}

}  // namespace

void merge_matching_ties(Deck& deck) {
  if (std::ranges::none_of(deck.cards, [](const RawCard& raw) { return raw.card.name == "TIE"; })) return;
  const std::set<std::int64_t> loaded = loaded_nodes(deck);
  const auto merge = [&](const RawCard& raw) {
    if (raw.card.name != "TIE" || raw.card.has("CYCLICSYMMETRY") || raw.card.has("FLUIDPERIODIC") ||
        raw.card.has("MULTISTAGE") || raw.data.size() != 1 || raw.data[0].size() < 2)
      return false;
    const auto pairs = partners(deck, nodes_of(deck, raw.data[0][0]), nodes_of(deck, raw.data[0][1]));
    if (pairs.empty() || std::ranges::any_of(pairs, [&](const auto& pair) { return loaded.contains(pair.first); }))
      return false;
    rename(deck, pairs);
    return true;
  };
  std::erase_if(deck.cards, merge);
}

}  // namespace creepcontact::deck
