#pragma once
/// Temperatures over the time of a run, as cubic polynomials between some times.

#include <functional>
#include <optional>
#include <vector>

#include "creepcontact/heat/conduction.hpp"

namespace creepcontact::heat {

/// Between two times the cubic polynomial with the values and rates at both (Hermite); constant if there is one time.
/// At a time where functions have a kink the rates before and after differ. Beyond the last time the course of the last
/// period repeats, if there is one.
struct History {
  std::vector<double> times;
  std::vector<std::vector<double>> values, rates_before, rates_after;  ///< [time][unknown]
  std::vector<double>
      kinks;  ///< of the run, those at which the integration starts again; up to the last time they are among the times
  std::optional<double> period;  ///< of the course beyond the last time
  long n_steps = 0;
};

/// What acts is periodic from a time on.
struct Repeats {
  double from = 0, period = 0;
};

struct HistoryOptions {
  double end = 0;
  std::vector<double> kinks;  ///< of the functions of t, within (0, end), increasing
  double tolerance = 0;       ///< of temperatures
  /// Where a step from `from` to `to` must end, so that it sees what functions of t do within it; empty: anywhere. They
  /// are smooth within the segment, whose ends are excluded.
  std::function<double(double from, double to, double begin_of_segment, double end_of_segment)> end_of_step = {};
  /// Given: the integration ends with a period after which the temperatures are those before it.
  std::optional<Repeats> repeats = {};
};

/// From temperatures at t = 0 on. Stores as few of the steps as reproduce all of them within a third of the tolerance.
/// @param start  temperatures at t = 0. @throws SolverError if the integration fails; ModelError as steady()
History integrate(Conduction& problem, std::vector<double> start, const HistoryOptions& options);

}  // namespace creepcontact::heat
