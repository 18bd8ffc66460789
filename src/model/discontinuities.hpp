#pragma once
/// Where an expression in t has kinks or jumps: the integration stops there and starts anew.

#include <span>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::model {

struct Discontinuities {
  std::vector<double>
      jumps;  ///< the double at which the value changes, or its neighbour if that is rounder; increasing
  std::vector<double> kinks;  ///< where the slope jumps or is infinite, to about 1e-12 relative; increasing
  bool too_many = false;      ///< there are more than can be found: both lists are empty
};

/// Those in (0, end), from samples at logarithmically and uniformly spaced times: what is wider than end/16000, or,
/// near 0, than 2 % of the time, is seen. Tables know their points themselves: none.
/// @param positions  at which functions of position are sampled; one at least
/// Cost: some 20000 evaluations a place, and some hundreds a kink.
Discontinuities find_discontinuities(const Function& function, double end, std::span<const Vector3> positions);

}  // namespace creepcontact::model
