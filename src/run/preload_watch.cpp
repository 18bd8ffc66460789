#include "preload_watch.hpp"

#include <algorithm>
#include <cmath>

#include "creepcontact/base/log.hpp"

namespace creepcontact::run {
namespace {

constexpr double soon = 1e-3;       // of the rest of the run: creep has done little yet
constexpr double no_matter = 0.01;  // of the force

bool yields(const mechanics::Body& body) {
  return std::ranges::any_of(body.material().creep, [](const auto& law) { return law->yields(); });
}

double normal_force(const contact::Pair& pair, const creep::Equilibrium& at) {
  return -pair.interference_gap().dot(at.contact.multiplier.segment(pair.first_row, pair.coupling.n_rows()));
}

}  // namespace

PreloadWatch::PreloadWatch(creep::CreepSystem& system, const std::vector<double>& breakpoints, double end,
                           double resumed_at)
    : system_(system) {
  const creep::Assembly& assembly = system.assembly();
  if (std::ranges::none_of(assembly.bodies(), yields)) return;
  for (std::size_t p = 0; p < assembly.pairs().size(); ++p) {
    const auto& preload = assembly.pairs()[p].preload;
    if (!preload || preload->time >= end) continue;
    double time = preload->time + soon * (end - preload->time);
    const auto next = std::ranges::upper_bound(breakpoints, preload->time);
    if (next != breakpoints.end()) time = std::min(time, *next);
    if (time > resumed_at) due_.push_back({p, time});
  }
}

void PreloadWatch::step(double t, std::span<const double> y) {
  const auto is_due = [t](const Look& look) { return look.time <= t; };
  if (std::ranges::none_of(due_, is_due)) return;
  const auto forces = [&](std::span<const double> state) {
    const creep::Equilibrium& at = system_.evaluate_output(t, state).equilibrium;
    std::vector<double> result;
    for (const Look& look : due_) result.push_back(normal_force(system_.assembly().pairs()[look.pair], at));
    return result;
  };
  const std::vector<double> now = forces(y), elastic = forces(std::vector<double>(y.size()));
  for (std::size_t i = 0; i < due_.size(); ++i)
    if (is_due(due_[i])) warn(due_[i].pair, t, now[i], elastic[i]);
  std::erase_if(due_, is_due);
}

void PreloadWatch::warn(std::size_t p, double t, double force, double elastic) const {
  const contact::Pair& pair = system_.assembly().pairs()[p];
  const double asked = pair.preload.value().force, lost = elastic - force;
  if (!(std::abs(lost) > no_matter * asked) || system_.team().rank() != 0) return;
  log::warning(
      "contact '{}': the material yields under its preload: at t = {:.6g} the normal force is {:.6g}, without "
      "inelastic "
      "strain it would be {:.6g}; preload.force asks for {:.6g} at t = {:.6g}, which is met before anything yields. If "
      "{:.6g} shall be left after tightening, ask for about {:.6g} and compare again",
      pair.name, t, force, elastic, asked, pair.preload->time, asked, asked * elastic / std::max(force, asked / 4));
}

}  // namespace creepcontact::run
