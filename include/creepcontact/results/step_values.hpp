#pragma once
/// What is taken from a state for the extremes of a run.

#include <array>
#include <vector>

#include "creepcontact/base/memory.hpp"

namespace creepcontact::results {

/// A state in a few numbers.
struct StepValues {
  double time = 0;
  std::vector<double> forces;       ///< normal force of every contact pair; 0 where it has none of interest
  std::vector<double> von_mises;    ///< per body
  std::vector<double> yield_share;  ///< likewise: largest_yield_share(), 0 where there is none
  std::vector<double> probes;       ///< of every probe
  /// Plastic strain of a body up to now.
  struct Flow {
    double largest = 0;             ///< accumulated
    std::array<double, 3> place{};  ///< of it
    double volume = 0;              ///< share of the volume that has yielded
    static constexpr auto members =
        std::tuple{Member{"largest", &Flow::largest}, Member{"place", &Flow::place}, Member{"volume", &Flow::volume}};
  };
  std::vector<Flow> flow;  ///< per body; empty if nothing may yield
};

}  // namespace creepcontact::results
