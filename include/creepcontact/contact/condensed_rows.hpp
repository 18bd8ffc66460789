#pragma once
/// Contact rows B of one body condensed onto the unknowns that a factor of its stiffness eliminates last:
///   G = L22^-1 B^T,   gaps of y = L^-1 P f: G^T y2,   forces of multipliers: y2 += G lambda,   flexibility F = G^T G.

#include <Eigen/Core>
#include <span>

#include "creepcontact/contact/geometry/pair.hpp"
#include "creepcontact/linalg/stiffness_solver.hpp"

namespace creepcontact::contact {

class CondensedRows {
 public:
  CondensedRows() = default;
  /// @param rows      B on all free unknowns, with entries at the trailing ones alone
  /// @param trailing  those of the factor. Cost: trailing.size()^2 x rows.rows() operations.
  CondensedRows(const RowMatrix& rows, std::span<const std::int64_t> trailing, const linalg::StiffnessSolver& factor);

  Eigen::MatrixXd flexibility() const { return traces_.transpose() * traces_; }
  /// @param y  of all free unknowns
  Eigen::VectorXd gaps(std::span<const double> y) const;
  void add_forces(const Eigen::VectorXd& multiplier, std::span<double> y) const;

 private:
  Eigen::MatrixXd traces_;  // G, trailing.size() x rows.rows()
};

}  // namespace creepcontact::contact
