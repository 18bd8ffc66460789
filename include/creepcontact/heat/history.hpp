#pragma once
/// Temperatures over the time of a run, as cubic polynomials between some times.

#include <functional>
#include <vector>

#include "creepcontact/heat/conduction.hpp"

namespace creepcontact::heat {

/// Between two times the cubic polynomial with the values and rates at both (Hermite); constant if there is one time.
/// At a time where functions have a kink the rates before and after differ.
struct History {
  std::vector<double> times;
  std::vector<std::vector<double>> values, rates_before, rates_after;  ///< [time][unknown]
  std::vector<double> kinks;  ///< among the times: those at which the integration has started again
  long n_steps = 0;
};

struct HistoryOptions {
  double end = 0;
  std::vector<double> kinks;  ///< of the functions of t, within (0, end), increasing
  double tolerance = 0;       ///< of temperatures
  /// Where a step from `from` to `to` must end, so that it sees what functions of t do within it; empty: anywhere. They
  /// are smooth within the segment, whose ends are excluded.
  std::function<double(double from, double to, double begin_of_segment, double end_of_segment)> end_of_step = {};
};

/// From temperatures at t = 0 on. Stores as few of the steps as reproduce all of them within a third of the tolerance.
/// @param start  temperatures at t = 0. @throws SolverError if the integration fails; ModelError as steady()
History integrate(Conduction& problem, std::vector<double> start, const HistoryOptions& options);

}  // namespace creepcontact::heat
