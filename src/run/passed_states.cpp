#include "passed_states.hpp"

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"

namespace creepcontact::run {
namespace {
constexpr int max_solved = 2000;  // two per breakpoint, one per step
}

bool PassedStates::evaluate(StepView& view) {
  if (!costs_solves_) {
    try {
      view.evaluation();
      return true;
    } catch (const RecoverableError&) {  // the integrator meets it next, and decides what becomes of the run
      return false;
    }
  }
  if (n_solved_ >= max_solved) return false;
  if (++n_solved_ == max_solved)
    log::warning(
        "the loads have more than {} states between output times that count: those after t = {:.6g} are not looked at, "
        "so that the largest values there are those of output times alone. Put output times where the loads are "
        "largest",
        max_solved, view.time());
  try {
    view.evaluation();
    return true;
  } catch (const Error& error) {
    log::warning("at t = {:.10g}, between output times, no equilibrium is found: {}", view.time(), error.what());
    return false;
  }
}

}  // namespace creepcontact::run
