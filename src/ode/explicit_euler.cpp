#include "explicit_euler.hpp"

#include <fmt/format.h>

#include <cmath>

#include "creepcontact/base/error.hpp"
#include "elementwise.hpp"

namespace creepcontact::ode {

void ExplicitEuler::attempt(const StepClock::Target& target) {
  for_each_index(state_.size(), [&](std::size_t i) { candidate_[i] = state_[i] + target.step * rate_[i]; });
  if (!std::isfinite(max_difference(candidate_, state_)))
    throw SolverError(fmt::format(
        "explicit_euler: the state has grown beyond all bounds after t = {:.6g}; steps of {:.3g} are unstable there, "
        "the stable step is {:.3g}. Take step = \"stable\", a smaller step, or cvode_bdf",
        time(), target.step, stable_step()));
  system_.rate(target.time, candidate_, candidate_rate_);
}

}  // namespace creepcontact::ode
