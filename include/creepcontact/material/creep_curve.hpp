#pragma once
/// Creep curves: the strain of a bar under constant stress, as a creep test measures it.

#include <vector>

#include "creepcontact/material/material.hpp"

namespace creepcontact::material {

/// Uniaxial stress and temperature, both constant.
struct CreepTest {
  double stress = 0;
  double temperature = 0;
  double end = 0;  ///< duration
};

/// Creep strain along the bar, thermal and elastic strain left out.
struct CreepCurve {
  std::vector<double> time, strain;  ///< increasing times, in equal steps of their logarithm
};

/// All mechanisms of a material together, over the last `decades` decades before test.end. The curve ends early where
/// the strain exceeds 1 or the rate grows without limit: rupture.
/// @returns an empty curve for an elastic material
/// Method: bar_history(). Cost: milliseconds.
CreepCurve creep_curve(const Material& material, const CreepTest& test, double decades = 6);

}  // namespace creepcontact::material
