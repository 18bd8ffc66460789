#pragma once
/// What heat sees of contact.

#include <vector>

#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/creep/equilibrium.hpp"

namespace creepcontact::creep {

/// Pressure and gap of all contact nodes, none negative.
struct JointValues {
  std::vector<double> pressure, gap;
  // NOLINTNEXTLINE(google-explicit-constructor): it is what heat sees of it
  operator heat::ContactAtNodes() const { return {pressure, gap}; }
};

JointValues joint_values(const Assembly& assembly, const Equilibrium& at);
/// Their change with multipliers and weighted gaps of all rows while what is closed stays closed.
JointValues joint_change(const Assembly& assembly, const Equilibrium& at, const Eigen::VectorXd& multiplier,
                         const Eigen::VectorXd& gap);

}  // namespace creepcontact::creep
