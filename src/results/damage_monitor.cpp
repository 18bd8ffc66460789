#include "creepcontact/results/damage_monitor.hpp"

#include <algorithm>
#include <array>

#include "creepcontact/base/log.hpp"

namespace creepcontact::results {
namespace {

constexpr double rupture_damage = 0.99;     // from here on it is rupture if life is known to end, or not known
constexpr double certain_rupture = 0.9999;  // whatever remains of life
constexpr double negligible_life = 1e-4;    // of the time that has passed
constexpr double small_strain = 1;          // creep strain beyond which results mean nothing any more

io::Summary::Largest largest(const creep::CreepSystem::Extreme& extreme) {
  return {extreme.value, {extreme.position.x(), extreme.position.y(), extreme.position.z()}};
}

}  // namespace

DamageMonitor::DamageMonitor(const creep::CreepSystem& system)
    : system_(system),
      counters_{{&material::damage, &io::Summary::damage, {}},
                {&material::life_fraction, &io::Summary::life_fraction, {}},
                {&material::fatigue_fraction, &io::Summary::fatigue_fraction, {}},
                {&material::creep_fatigue, &io::Summary::creep_fatigue, {}},
                {&material::remaining_life, &io::Summary::remaining_life, {}}} {}

creep::CreepSystem::Extreme DamageMonitor::largest_damage(const creep::Evaluation& at,
                                                          std::span<const double> y) const {
  creep::CreepSystem::Extreme result;
  if (!has_damage()) return result;
  for (std::size_t b = 0; b < system_.assembly().bodies().size(); ++b)
    if (const auto of_body = system_.largest(material::damage, b, at, y); of_body && of_body->value > result.value)
      result = *of_body;
  return result;
}

bool DamageMonitor::is_rupture(const creep::CreepSystem::Extreme& damage, double time, const creep::Evaluation& at,
                               std::span<const double> y) const {
  if (damage.value < rupture_damage) return false;
  if (damage.value >= certain_rupture) return true;
  const auto consumption = system_.largest(material::remaining_life, damage.body, at, y);
  return !consumption || consumption->value * negligible_life * time >= 1;
}

void DamageMonitor::output(const creep::Evaluation& at) {
  for (std::size_t b = 0; b < at.equilibrium.bodies.size(); ++b) {
    for (Counter& counter : counters_)
      if (const auto found = system_.largest(*counter.variable, b, at, at.y)) counter.largest[b] = *found;
  }
}

void DamageMonitor::warn(double time, const creep::Evaluation& at, std::span<const double> y) {
  const std::vector<mechanics::Body>& bodies = system_.assembly().bodies();
  const Team& team = system_.assembly().team();
  std::vector<mechanics::CreepStrainView> views;
  system_.layout().views(y, views);
  for (std::size_t b = 0; b < bodies.size() && !warned_of_strain_; ++b) {
    std::array<double, 4> large{};  // the strain, if it is large, and its place
    for (std::size_t p = 0; !views[b].empty() && large[0] == 0 && p < bodies[b].discretization().n_points(); ++p) {
      const tensor::ConstMap strain = views[b].at(p);
      if (!(strain.squaredNorm() > small_strain * small_strain)) continue;  // more than that of its deviator
      const double equivalent = tensor::equivalent_strain(strain);
      const Vector3& x = bodies[b].discretization().point_coordinates()[p];
      if (equivalent > small_strain) large = {equivalent, x.x(), x.y(), x.z()};
    }
    team.broadcast(large, team.rank_of_max(large[0] > 0 ? 1 : 0));
    if (large[0] == 0) continue;
    log::warning(
        "body '{}': the creep strain has reached {:.3g} at ({:.6g}, {:.6g}, {:.6g}), t = {:.6g}; the theory assumes "
        "small strain. Check the units of the creep constants of material '{}', or end the run earlier",
        bodies[b].name(), large[0], large[1], large[2], large[3], time, bodies[b].material().name);
    warned_of_strain_ = true;
  }
  for (std::size_t b = 0; b < bodies.size() && !warned_of_life_; ++b) {
    const auto life = system_.largest(material::life_fraction, b, at, y);
    if (!life || !(life->value > 1)) continue;
    log::warning(
        "body '{}': the creep life is used up before t = {:.6g} at ({:.6g}, {:.6g}, {:.6g}): life_fraction {:.3g}",
        bodies[b].name(), time, life->position.x(), life->position.y(), life->position.z(), life->value);
    warned_of_life_ = true;
  }
  for (std::size_t b = 0; b < bodies.size() && !warned_of_creep_fatigue_; ++b) {
    const auto usage = system_.largest(material::creep_fatigue, b, at, y);
    if (!usage || !(usage->value > 1)) continue;
    log::warning(
        "body '{}': creep and fatigue have passed the line of the interaction diagram before t = {:.6g} at ({:.6g}, "
        "{:.6g}, {:.6g}): creep_fatigue {:.3g}",
        bodies[b].name(), time, usage->position.x(), usage->position.y(), usage->position.z(), usage->value);
    warned_of_creep_fatigue_ = true;
  }
}

void DamageMonitor::fill(io::Summary& summary) const {
  const std::vector<mechanics::Body>& bodies = system_.assembly().bodies();
  for (const Counter& counter : counters_)
    for (const auto& [b, extreme] : counter.largest) {
      io::Summary::Largest found = largest(extreme);
      if (counter.variable->is_reciprocal) {
        if (!(extreme.value > 0)) continue;
        found.value = 1 / extreme.value;
      }
      (summary.*counter.member)[bodies[b].name()] = found;
    }
  if (rupture_) summary.rupture = {rupture_->first, bodies[rupture_->second.body].name(), largest(rupture_->second)};
}

}  // namespace creepcontact::results
