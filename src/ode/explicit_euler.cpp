#include "explicit_euler.hpp"

#include <fmt/format.h>

#include <cmath>

#include "elementwise.hpp"

namespace creepcontact::ode {

void ExplicitEuler::advance(const EulerPoint& from, const StepClock::Target& target, EulerPoint& to) {
  for_each_index(from.state.size(), [&](std::size_t i) { to.state[i] = from.state[i] + target.step * from.rate[i]; });
  if (!std::isfinite(max_difference(to.state, from.state)))
    fail(fmt::format(
        "explicit_euler: the state has grown beyond all bounds after t = {:.6g}; steps of {:.3g} are unstable there, "
        "the stable step is {:.3g}. Take step = \"stable\" or \"adaptive\", a smaller step, or cvode_bdf",
        time(), target.step, stable_step()));
}

void ExplicitEuler::complete(double t, EulerPoint& to) {
  system_.rate(t, to.state, to.rate);
}

}  // namespace creepcontact::ode
