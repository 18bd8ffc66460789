#pragma once
/// A first step for methods with error control.

#include <vector>

#include "creepcontact/ode/integrator.hpp"
#include "creepcontact/ode/system.hpp"
#include "error_norm.hpp"

namespace creepcontact::ode {

/// Where a first step starts, and what bounds it.
struct Start {
  const Integrator& of;
  double time = 0;
  const std::vector<double>& state;
  const std::vector<double>& rate;
  double latest = 0;  ///< where it ends at the latest
  double stable = 0;  ///< stable step of explicit Euler
};

/// A tenth of the step over which the rate changes the state by the tolerance, found from half a stable step.
/// Cost: one rate evaluation, and one more for each failure that was answered by a quarter of the length.
/// @param state, rate  work space
/// @throws SolverError if none of them succeeds
/// Source: Sommeijer, Shampine, Verwer (1997), section 3.3.
double first_step(System& system, const ErrorNorm& norm, const Start& start, std::vector<double>& state,
                  std::vector<double>& rate, std::int64_t& failures);

/// The end of a first step towards t_limit, at the latest, where the run ends at end_time (if that lies ahead).
double latest_first_end(double time, double t_limit, double end_time);

}  // namespace creepcontact::ode
