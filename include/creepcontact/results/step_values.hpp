#pragma once
/// What is taken from a state for the extremes of a run.

#include <vector>

namespace creepcontact::results {

/// A state in a few numbers.
struct StepValues {
  double time = 0;
  std::vector<double> forces;       ///< normal force of every contact pair; 0 where it has none of interest
  std::vector<double> von_mises;    ///< per body
  std::vector<double> yield_share;  ///< likewise: largest_yield_share(), 0 where there is none
  std::vector<double> probes;       ///< of every probe
};

}  // namespace creepcontact::results
