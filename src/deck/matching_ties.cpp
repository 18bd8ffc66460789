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

/// Two forces, or flows of heat, on nodes that become one would not add up.
std::set<std::int64_t> loaded_nodes(const Deck& deck) {
  const Resolver resolver(deck);
  std::set<std::int64_t> nodes;
  for (const Step& step : deck.steps)
    for (const RawCard& raw : step.cards)
      if (raw.card.name == "CLOAD" || raw.card.name == "CFLUX")
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

/// Pairs of nodes at one place whose temperatures a card sets equal; empty if it says something else too.
std::vector<std::pair<std::int64_t, std::int64_t>> equal_temperatures(const Deck& deck, const RawCard& equation) {
  constexpr std::size_t n_terms = 2;
  const Resolver resolver(deck);
  Eigen::AlignedBox3d box;
  for (const Vector3& position : deck.positions) box.extend(position);
  std::vector<std::pair<std::int64_t, std::int64_t>> result;
  std::vector<std::string> fields;  // of one equation, after the number of its terms
  bool is_begun = false;
  for (const std::vector<std::string>& line : equation.data) {
    if (!std::exchange(is_begun, true)) {
      if (line.size() != 1 || whole_number(line[0]) != n_terms) return {};
      continue;
    }
    fields.insert(fields.end(), line.begin(), line.end());
    if (fields.size() < 3 * n_terms) continue;
    const Numbers first = resolver.nodes(fields[0]), second = resolver.nodes(fields[3]);
    const bool is_of_temperatures = (fields[1] == "11" || fields[1] == "0") && (fields[4] == "11" || fields[4] == "0");
    const auto a = number(fields[2]), b = number(fields[5]);
    if (fields.size() > 3 * n_terms || !is_of_temperatures || !a || !b || *a == 0 || *a + *b != 0 ||
        first.size() != 1 || second.size() != 1 || first == second)
      return {};
    const Vector3 apart =
        deck.positions[deck.node_of_number.at(first[0])] - deck.positions[deck.node_of_number.at(second[0])];
    if (apart.norm() > same_place * box.diagonal().norm()) return {};
    result.emplace_back(first[0], second[0]);
    fields.clear();
    is_begun = false;
  }
  return result;
}

}  // namespace

void merge_equal_temperatures(Deck& deck) {
  if (deck.steps.empty() || !deck.conducts() || deck.deforms()) return;
  const std::set<std::int64_t> loaded = loaded_nodes(deck);
  std::erase_if(deck.cards, [&](const RawCard& raw) {
    if (raw.card.name != "EQUATION") return false;
    bool is_merged = false;
    // One pair after the other: a later one may name a node that has become another.
    for (auto [from, to] : equal_temperatures(deck, raw)) {
      if (loaded.contains(from) || loaded.contains(to)) return false;
      const auto now = [&](std::int64_t node) {
        const auto found = deck.same_as.find(node);
        return found == deck.same_as.end() ? node : found->second;
      };
      if (now(from) != now(to)) rename(deck, {{now(from), now(to)}});
      is_merged = true;
    }
    return is_merged;
  });
}

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
