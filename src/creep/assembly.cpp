#include "creepcontact/creep/assembly.hpp"

#include <algorithm>

namespace creepcontact::creep {
namespace {

std::vector<contact::Pair> numbered(std::vector<contact::Pair> pairs) {
  contact::number_rows(pairs);
  return pairs;
}

}  // namespace

Assembly::Assembly(std::vector<mechanics::Body> bodies, std::vector<contact::Pair> pairs, const Remake& remake,
                   const Team& team)
    : team_(&team), bodies_(std::move(bodies)), pairs_(numbered(std::move(pairs))), rigid_body_modes_(bodies_, pairs_) {
  if (!remake) return;
  const auto sliding = rigid_body_modes_.sliding(pairs_);
  bool remade = false;
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    if (sliding[p].empty() || pairs_[p].coupling.type == contact::ContactType::tied) continue;
    pairs_[p] = remake(bodies_, p, sliding[p]);
    remade = true;
  }
  if (!remade) return;
  contact::number_rows(pairs_);
  rigid_body_modes_ = contact::RigidBodyModes(bodies_, pairs_);
}

bool Assembly::creeps() const {
  return std::ranges::any_of(bodies_, [](const mechanics::Body& body) { return body.material().creeps(); }) ||
         std::ranges::any_of(pairs_,
                             [](const contact::Pair& pair) { return pair.gasket && pair.gasket->kind().creep; });
}

void Assembly::update(double t, std::vector<mechanics::BodyConditions>& conditions,
                      std::span<const std::vector<double>> temperatures) const {
  conditions.resize(bodies_.size());
  together(team(), [&] {
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      bodies_[b].update(t, conditions[b], temperatures.empty() ? std::span<const double>() : temperatures[b]);
  });
}

std::vector<mechanics::BodyConditions> Assembly::at(double t) const {
  std::vector<mechanics::BodyConditions> conditions;
  update(t, conditions);
  return conditions;
}

}  // namespace creepcontact::creep
