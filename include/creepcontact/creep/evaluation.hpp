#pragma once
/// The equilibrium of a state of creep.

#include <vector>

#include "creepcontact/creep/equilibrium.hpp"
#include "creepcontact/creep/material_points.hpp"

namespace creepcontact::creep {

/// The equilibrium of a state (t, y) and the parameters of the laws at that time.
struct Evaluation {
  double time = 0;        ///< the time at which the loads are taken
  std::vector<double> y;  ///< the state, of size StateLayout::size()
  Equilibrium equilibrium;
  std::vector<LawParameters> laws;  ///< one per body
  /// Temperatures of the unknowns of HeatModel, if they are part of the state; else empty.
  std::vector<double> temperatures;
  /// Tangents at all points, one list per body; meaningful where has_tangents.
  std::vector<std::vector<material::StressTangent>> tangents;
  bool has_tangents = false;
  bool valid = false;  ///< false until a solve has succeeded
};

}  // namespace creepcontact::creep
