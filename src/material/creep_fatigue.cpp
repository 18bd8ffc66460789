#include "creepcontact/material/creep_fatigue.hpp"

#include <fmt/format.h>

#include "creepcontact/base/error.hpp"

namespace creepcontact::material {

PointState CreepFatigue::of_creep(const PointState& at) {
  PointState part = at;
  part.internal = at.internal.first(1);
  return part;
}

void CreepFatigue::rate(const PointState& at, PointRate into) const {
  into.internal[0] = into.internal[1] = 0;
  if (creep_) creep_->rate(of_creep(at), {into.creep_strain, into.internal.first(1)});
}

void CreepFatigue::derivative(const PointState& at, const PointChange& change, PointRate into) const {
  into.internal[0] = into.internal[1] = 0;
  if (creep_) creep_->derivative(of_creep(at), change, {into.creep_strain, into.internal.first(1)});
}

bool CreepFatigue::evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const {
  if (&variable == &material::life_fraction && creep_)
    into[0] = at.internal[0];
  else if (&variable == &material::fatigue_fraction)
    into[0] = at.internal[1];
  else if (&variable == &material::creep_fatigue)
    into[0] = diagram_.usage(at.internal[0], at.internal[1]);
  else
    return false;
  return true;
}

void CreepFatigue::add_cycle(const CycleRange& cycle, std::span<double> internal) const {
  if (!(cycle.strain_range > 0)) return;
  const double cycles = curve_->cycles(cycle.strain_range, cycle.temperature);
  if (!(cycles > 0))
    throw ModelError(
        fmt::format("the fatigue data give {} cycles to failure for a strain range of {:.4g} at T = {:.4g}", cycles,
                    cycle.strain_range, cycle.temperature));
  internal[1] += 1 / cycles;
}

}  // namespace creepcontact::material
