#pragma once
/// Preloads by force in bodies that yield. The interference of a preload is found for elastic bodies; where its stress
/// is beyond the yield stress, the force falls within the first steps.

#include <span>
#include <vector>

#include "creepcontact/creep/creep_system.hpp"

namespace creepcontact::run {

/// Looks at each preload once, soon after it is applied, and warns if yielding has changed its force.
class PreloadWatch {
 public:
  /// @param system, breakpoints (ascending)  must outlive the object @param end  of the run
  /// @param resumed_at  preloads that were looked at before are left out
  PreloadWatch(creep::CreepSystem& system, const std::vector<double>& breakpoints, double end, double resumed_at);

  /// An accepted step. Collective. Cost: nothing but at the times of its looks, with two solves at most.
  void step(double t, std::span<const double> y);

 private:
  struct Look {
    std::size_t pair;
    double time;  ///< from which on it is due
  };
  void warn(std::size_t pair, double t, double force, double elastic) const;

  creep::CreepSystem& system_;
  std::vector<Look> due_;
};

}  // namespace creepcontact::run
