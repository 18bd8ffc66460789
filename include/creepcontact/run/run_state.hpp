#pragma once
/// Where a run is.

#include <vector>

#include "creepcontact/base/run_counters.hpp"

namespace creepcontact::run {

/// What the loop of a run knows of itself. It is all that a checkpoint holds of the loop; integrator, system and
/// observers add what they hold.
struct RunState {
  double time = 0;
  std::vector<double> y = {};      ///< accepted state at `time`, of this process (creep::StateLayout)
  RunCounters earlier = {};        ///< work of the runs that this one continues
  std::vector<double> jumps = {};  ///< breakpoints that the model does not have: jumps found by steps, ascending
};

}  // namespace creepcontact::run
