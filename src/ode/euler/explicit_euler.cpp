#include "explicit_euler.hpp"

#include <fmt/format.h>

#include <cmath>

#include "../elementwise.hpp"
#include "../state_norms.hpp"
#include "creepcontact/base/log.hpp"

namespace creepcontact::ode {

void ExplicitEuler::initialize(double t, std::span<const double> y, double step) {
  EulerScheme::initialize(t, y, step);
  made_ = options_.step.length;
  warn_if_unstable(t, y);
}

void ExplicitEuler::advance(const EulerPoint& from, const StepClock::Target& target, EulerPoint& to) {
  made_ = target.step;
  for_each_index(from.state.size(), [&](std::size_t i) { to.state[i] = from.state[i] + target.step * from.rate[i]; });
  if (!std::isfinite(max_difference(system_.team(), to.state, from.state)))
    fail(
        fmt::format("explicit_euler: the solution diverges after t = {:.6g}; steps of {:.3g} are unstable there, the "
                    "stable step is {:.3g}. Use step = \"stable\" or \"adaptive\", a smaller step, or cvode_bdf",
                    time(), target.step, stable_step()));
}

void ExplicitEuler::complete(double t, EulerPoint& to) {
  system_.rate(t, to.state, to.rate);
  warn_if_unstable(t, to.state);  // without a solve: the rate has just been evaluated
}

void ExplicitEuler::warn_if_unstable(double t, std::span<const double> y) {
  const bool in_stable_steps = options_.step.mode == StepMode::stable;
  if (warned_ || adaptive() || (in_stable_steps && options_.step_factor <= 1)) return;
  const double stable = system_.stable_step(t, y);
  if (!(made_ > stable)) return;
  warned_ = true;
  log::warning(
      "explicit_euler: the step of {:.3g} is longer than the stable one of {:.3g} at t = {:.6g}; the stress will "
      "oscillate. Use {}, a smaller step, or another integrator",
      made_, stable, t, in_stable_steps ? "step_factor = 1 or less" : "step = \"stable\" or \"adaptive\"");
}

}  // namespace creepcontact::ode
