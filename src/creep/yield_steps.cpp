#include "creepcontact/creep/yield_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "creepcontact/base/index.hpp"

namespace creepcontact::creep {
namespace {

constexpr double share_of_stress = 0.1;
constexpr double share_of_yield_stress = 0.1;
constexpr double kept_size = 0.97;  // per step: a stress that passes through zero is not followed in steps of nothing
constexpr int first_steps = 32;     // in a segment, as long as nothing is known of it
// SUNDIALS ends the next step within the present limit: of a growth by three, two remain.
constexpr double max_yield_growth = 3, max_yield_cut = 0.2;

/// Down to one of four values per octave: rounding errors of the stress do not change the steps.
double rounded_down(double length) {
  return std::exp2(std::floor(4 * std::log2(length)) / 4);
}

}  // namespace

YieldSteps::YieldSteps(const Assembly& assembly) : assembly_(assembly) {
  for (std::size_t b = 0; b < assembly.bodies().size(); ++b)
    if (std::ranges::any_of(assembly.bodies()[b].material().creep, [](const auto& law) { return law->yields(); }))
      bodies_.push_back(b);
  may_flow_ = std::ranges::any_of(assembly.bodies(),
                                  [](const mechanics::Body& body) { return body.material().plasticity != nullptr; });
  state_.size.assign(bodies_.size(), 0.0);
  begin_segment();
}

void YieldSteps::begin_segment() {
  state_.longest = 0;
  state_.flow.reset();
  stress_.assign(bodies_.size(), {});
  has_stress_ = false;
}

void YieldSteps::keep(const Equilibrium& at) {
  time_ = at.time;
  has_stress_ = true;
  for (std::size_t i = 0; i < bodies_.size(); ++i) stress_[i] = at.bodies[bodies_[i]].stress;
}

void YieldSteps::save(Memory& memory) const {
  memory.save("yield_steps", state_);
}

void YieldSteps::resume(const Memory& memory, const std::function<const Equilibrium&()>& at) {
  if (!bodies_.empty()) keep(at());
  memory.restore("yield_steps", state_);
}

void YieldSteps::accept(const Equilibrium& at) {
  if (bodies_.empty()) return;
  if (!has_stress_ || !(at.time > time_)) return keep(at);
  double largest = 0;  // change, relative to the allowed one
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const std::vector<double>&before = stress_[i], &now = at.bodies[bodies_[i]].stress;
    std::array<double, 2> change_and_size{0, std::pow(kept_size * state_.size[i], 2)};
    for (std::size_t p = 0; p < now.size() / 6; ++p) {
      const tensor::ConstMap first = tensor::view(before, p), last = tensor::view(now, p);
      change_and_size[0] = std::max(change_and_size[0], tensor::squared_von_mises(Tensor6(last - first)));
      change_and_size[1] =
          std::max({change_and_size[1], tensor::squared_von_mises(first), tensor::squared_von_mises(last)});
    }
    assembly_.team().max(change_and_size);
    const double change = std::sqrt(change_and_size[0]);
    state_.size[i] = std::sqrt(change_and_size[1]);
    if (state_.size[i] > 0) largest = std::max(largest, change / (share_of_stress * state_.size[i]));
  }
  const double factor = largest > 0 ? std::clamp(1 / largest, max_yield_cut, max_yield_growth) : max_yield_growth;
  state_.longest = rounded_down((at.time - time_) * factor);
  keep(at);
}

double YieldSteps::longest(double t, double end, const std::function<double()>& excursion) {
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  if (may_flow_ && std::isfinite(end) && !state_.flow) {
    const double change = excursion();
    state_.flow = change > 0 ? (end - t) * share_of_yield_stress / change : unbounded;
  }
  const double for_laws = bodies_.empty() ? unbounded : state_.longest > 0 ? state_.longest : (end - t) / first_steps;
  return std::min(for_laws, state_.flow.value_or(unbounded));
}

}  // namespace creepcontact::creep
