#pragma once
/// What a step must not pass in a course: jumps, kinks, turns; and bounds on steps where it vibrates.

#include <optional>
#include <vector>

#include "creepcontact/model/step_limits.hpp"
#include "discontinuities.hpp"
#include "extrema.hpp"

namespace creepcontact::model {

struct CourseEvents {
  std::vector<double> jumps, kinks;
  std::vector<Turn> turns;
  std::vector<StepLimit> limits;  ///< that may replace the turns
  double n_turns = 0;
  bool vibrates = false;  ///< turns are too many, and most are missing
  bool too_many = false;  ///< jumps and kinks, which are then missing
};

/// How much a search may cost.
struct SearchEffort {
  int samples = run_samples;
  double turn_evaluations = model::turn_evaluations;
  double comparisons = 4e5;  ///< with other cycles, altogether ...
  int fewest_phases = 29;    ///< ... and of each cycle
};

/// Up to `end`. If the course repeats from the second cycle on, but for some cycles, one cycle is searched and the
/// others follow; those that differ are searched themselves. All cycles are compared. A course with more jumps and
/// kinks than can be found is searched for a period of its own.
/// @param cycle  a period that is known
CourseEvents find_events(const Course& course, double end, std::optional<double> cycle, const SearchEffort& effort);

}  // namespace creepcontact::model
