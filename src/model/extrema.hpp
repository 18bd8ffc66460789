#pragma once
/// Where a function of time turns back, and how fast it changes between two turns: a step that reaches over such a
/// time may miss a whole pulse of load.

#include <vector>

#include "creepcontact/model/step_limits.hpp"
#include "discontinuities.hpp"

namespace creepcontact::model {

/// A maximum or minimum.
struct Turn {
  double time = 0;
  double error = 0;  ///< distance of the samples there; the time itself is known better where the function is smooth
};

struct Extrema {
  /// Increasing; if there are more than `most_turns`, only the highest and the lowest that were seen, where loads have
  /// their extremes.
  std::vector<Turn> turns;
  std::vector<StepLimit> limits;  ///< bounds on steps that resolve each rise and fall, instead of stops at the turns
  std::vector<double> jumps;      ///< seen between turns that are too close for find_discontinuities
  double count = 0;               ///< number of turns
  /// Where there are so many turns that find_discontinuities sees nothing else with this number of samples.
  std::vector<Interval> dense;
};

/// Function values that a search may cost.
constexpr double turn_evaluations = 2e6;
/// More in one function are a vibration: bounds on steps cost less than stops.
constexpr std::size_t most_turns = 100;

/// In an interval, from 8192 samples, and eight or more between any two turns that these and windows of closer samples
/// show. Turns by less than 1 % of the whole change are none.
/// Cost: some 15000 evaluations, where there are more turns 10 per turn, but no more than `evaluations`. Turns that are
/// too many for that are counted by samples, and bounds on steps follow from their mean distance.
/// @param samples  see Extrema::dense
Extrema find_extrema(const Course& course, Interval over, double evaluations = turn_evaluations,
                     int samples = run_samples);

}  // namespace creepcontact::model
