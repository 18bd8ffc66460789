#include "life_record.hpp"

#include <algorithm>

namespace creepcontact::simulation {
namespace {

using material::Measure;

/// Pressures times the areas of their nodes; tied surfaces may pull.
double normal_force(const contact::Pair& pair, const Eigen::VectorXd& multipliers) {
  double force = 0;
  for (std::size_t i = 0; i < pair.coupling.nodes.size(); ++i) {
    const auto row = pair.first_row + static_cast<Eigen::Index>(i);
    force += pair.coupling.area[i] * multipliers[row];
  }
  return force;
}

io::Summary::Largest largest(const CreepRate::Extreme& extreme) {
  return {extreme.value, {extreme.place.x(), extreme.place.y(), extreme.place.z()}};
}

}  // namespace

LifeRecord::LifeRecord(const CreepRate& system)
    : system_(system),
      largest_force_(system.elasticity().interface().pairs().size(), 0.0),
      final_force_(largest_force_) {}

CreepRate::Extreme LifeRecord::largest_damage(std::span<const double> y) const {
  CreepRate::Extreme result;
  if (!system_.knows(Measure::damage)) return result;
  for (std::size_t b = 0; b < system_.elasticity().states().size(); ++b) {
    const CreepRate::Extreme of_body = system_.largest(Measure::damage, b, y);
    if (of_body.value > result.value) result = of_body;
  }
  return result;
}

void LifeRecord::output(std::span<const double> y) {
  const ContactElasticity& elasticity = system_.elasticity();
  for (std::size_t p = 0; p < final_force_.size(); ++p) {
    const contact::Pair& pair = elasticity.interface().pairs()[p];
    if (pair.coupling.type == contact::ContactType::tied) continue;
    final_force_[p] = normal_force(pair, elasticity.multipliers());
    largest_force_[p] = std::max(largest_force_[p], final_force_[p]);
  }
  for (std::size_t b = 0; b < elasticity.states().size(); ++b) {
    if (!system_.measure(Measure::damage, b, y).empty()) damage_[b] = system_.largest(Measure::damage, b, y);
    if (!system_.measure(Measure::life_fraction, b, y).empty())
      life_[b] = system_.largest(Measure::life_fraction, b, y);
  }
}

void LifeRecord::fill(io::Summary& summary) const {
  const auto& bodies = system_.elasticity().model().bodies;
  for (const auto& [b, extreme] : damage_) summary.damage[bodies[b]->name()] = largest(extreme);
  for (const auto& [b, extreme] : life_) summary.life_fraction[bodies[b]->name()] = largest(extreme);
  if (rupture_) summary.rupture = {rupture_->first, bodies[rupture_->second.body]->name(), largest(rupture_->second)};
  for (std::size_t p = 0; p < final_force_.size(); ++p) {
    const contact::Pair& pair = system_.elasticity().interface().pairs()[p];
    if (pair.coupling.type != contact::ContactType::tied)
      summary.contacts[pair.name] = {largest_force_[p], final_force_[p]};
  }
}

void LifeRecord::restore(const ContactElasticity::Memory& memory) {
  const auto found = memory.find("largest_contact_force");
  if (found != memory.end() && found->second.size() == largest_force_.size()) largest_force_ = found->second;
}

}  // namespace creepcontact::simulation
