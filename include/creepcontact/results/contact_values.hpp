#pragma once
/// Results at the multiplier nodes of a contact pair.

#include "creepcontact/contact/geometry/pair.hpp"
#include "creepcontact/creep/equilibrium.hpp"

namespace creepcontact::results {

/// Values at one multiplier node. A tied surface carries a vector: its pressure is the part along the normal (tension
/// negative), and its gap is zero.
struct ContactValues {
  double pressure = 0;
  double gap = 0;
  Vector3 traction = Vector3::Zero();  ///< on the slave body
  double shear = 0;                    ///< magnitude of the tangential traction
  double slip = 0;                     ///< accumulated [length]; 0 without friction
  double status = 0;                   ///< 0: open, 1: stick, 2: slip (a closed contact without friction slips)
};

ContactValues contact_values(const contact::Pair& pair, std::size_t node, const creep::Equilibrium& at);

/// Sum of pressure times nodal area over the pair; of a preloaded tied contact the tension across it. @param
/// multipliers  of all pairs
double normal_force(const contact::Pair& pair, const Eigen::VectorXd& multipliers);

}  // namespace creepcontact::results
