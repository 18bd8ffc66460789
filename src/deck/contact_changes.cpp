#include "contact_changes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "node_to_face_ties.hpp"

namespace creepcontact::deck {

SurfacePair surface_pair(const std::string& a, const std::string& b) {
  return std::minmax({upper_case(a), upper_case(b)});
}

Removals removals_of_pairs(Draft& draft) {
  std::set<SurfacePair> known;
  for (const RawCard* raw : draft.cards("CONTACT PAIR"))
    for (const std::vector<std::string>& line : raw->data)
      if (line.size() > 1) known.insert(surface_pair(line[0], line[1]));
  Removals all;
  for (std::size_t s = 0; s < draft.deck.steps.size(); ++s) {
    const double time = s == 0 ? 0 : draft.loading.step_ends[s - 1];
    for (const RawCard& raw : draft.deck.steps[s].cards) {
      if (raw.card.name != "MODEL CHANGE") continue;
      const bool removes = raw.card.has("REMOVE");
      if (removes == raw.card.has("ADD")) draft.refuse(raw, "expected either REMOVE or ADD");
      if (raw.card.value("TYPE").empty())
        draft.refuse(raw, "TYPE is missing; CONTACT PAIR is known, elements that come and go are not");
      for (const std::vector<std::string>& line : raw.data) {
        const SurfacePair pair = surface_pair(line.empty() ? "" : line[0], line.size() > 1 ? line[1] : "");
        if (!known.contains(pair)) {
          draft.refuse(raw, fmt::format("there is no *CONTACT PAIR of '{}' and '{}'", pair.first, pair.second));
          continue;
        }
        Course& removed = all[pair];
        if (time > 0) removed.add(time, removed.last());  // a jump
        removed.add(time, removes ? 1 : 0);
        if (time > 0) draft.changes.insert(time);
      }
    }
  }
  std::erase_if(all, [](const auto& one) { return one.second.is_zero(); });
  return all;
}

double distance_of_removed(const Deck& deck) {
  Eigen::AlignedBox3d box;
  for (const Vector3& position : deck.positions) box.extend(position);
  return box.diagonal().norm();
}

std::optional<double> even_distance(const Deck& deck, const std::vector<ElementFace>& slave,
                                    const std::vector<ElementFace>& master) {
  constexpr double rounding = 1e-6;  // of the size of the slave
  Vector3 normal = Vector3::Zero();
  Eigen::AlignedBox3d box;
  for (const ElementFace& face : slave) normal += outward_area(deck, face);
  std::optional<double> first;
  double spread = 0;
  for (const auto& [node, nearest] : nearest_points(deck, slave, master)) {
    const Vector3& position = deck.positions[deck.node_of_number.at(node)];
    box.extend(position);
    const double along = normal.normalized().dot(nearest.position - position);
    const double own = along < 0 ? -nearest.distance : nearest.distance;
    spread = std::max({spread, std::abs(own - first.value_or(own)), nearest.distance - std::abs(along)});
    if (!first) first = own;
  }
  const double least = rounding * box.diagonal().norm();
  if (!first || spread > least) return std::nullopt;
  return std::abs(*first) <= least ? 0 : *first;
}

}  // namespace creepcontact::deck
