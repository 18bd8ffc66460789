#pragma once
/// How a stiffness differs from that of the factors.

#include <vector>

#include "creepcontact/contact/condensed_interface.hpp"
#include "creepcontact/creep/assembly.hpp"

namespace creepcontact::creep {

/// K(t) = s K0 up to a relative deviation q, K0 the stiffness that is factored (see EquilibriumSolver).
struct StiffnessChange {
  double scale = 1, rest = 0;  ///< s and q
  /// With a solver of this error bound instead of the factors.
  StiffnessChange solved_with(double error) const { return {scale, rest + error + rest * error}; }
};

/// The change of the stiffness under these conditions (one per body). Collective.
StiffnessChange stiffness_change(const Assembly& assembly, const contact::CondensedInterface& interface,
                                 const std::vector<mechanics::BodyConditions>& at);

/// True if the stiffness of a body changes in time.
bool stiffness_changes(const Assembly& assembly);

}  // namespace creepcontact::creep
