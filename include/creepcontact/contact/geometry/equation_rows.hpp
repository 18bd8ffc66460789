#pragma once
/// Linear equations between displacements of nodes of two bodies, or of one.

#include <span>
#include <vector>

#include "creepcontact/contact/geometry/node_ties.hpp"

namespace creepcontact::contact {

/// coefficient . u(node)
struct EquationTerm {
  std::int64_t node = 0;
  Vector3 coefficient = Vector3::Zero();
};

/// Sum of the terms of both bodies = value.
struct LinearEquation {
  std::vector<EquationTerm> slave;  ///< at least one
  std::vector<EquationTerm> master;
};

/// One tied row per equation: area / (largest coefficient) times its terms. Its multiplier times area / (largest
/// coefficient) is the generalised force of the equation.
/// @param area  > 0, typical of a node
MortarCoupling equation_rows(const TiedBody& slave, const TiedBody& master, std::span<const LinearEquation> equations,
                             double area);

/// Change of the weighted gaps of these rows per unit of the value of their equations.
Eigen::VectorXd gap_per_value(std::span<const LinearEquation> equations, double area);

}  // namespace creepcontact::contact
