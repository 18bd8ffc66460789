#pragma once
/// Bounds on the length of steps where functions of the configuration change fast.

#include <cstddef>
#include <vector>

namespace creepcontact::model {

/// No step that meets this interval of time is longer.
struct StepLimit {
  double begin = 0, end = 0;
  double step = 0;  ///< > 0
};

/// All of them, which may overlap. Immutable.
class StepLimits {
 public:
  StepLimits() = default;
  explicit StepLimits(const std::vector<StepLimit>& limits);

  /// The latest end of a step that begins at t; infinity: no bound. A step may end in an interval after t, no further
  /// from its begin than the step allowed there. Cost: a search.
  double latest_end(double t) const;
  bool empty() const { return begins_.empty(); }
  /// The smallest number of steps that they ask for.
  double n_steps() const { return n_steps_; }

 private:
  // Pieces of time in which the same intervals hold, by their begins: the shortest step of these intervals, and the
  // earliest of begin + step of those that begin later.
  std::vector<double> begins_, steps_, ahead_;
  double n_steps_ = 0;
};

}  // namespace creepcontact::model
