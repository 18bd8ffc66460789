#pragma once
/// Contact rows B of one body condensed onto the trailing dofs, which the factor of its stiffness eliminates last.
///   G = L22^-1 B^T,   gaps of y = L^-1 P f: G^T y2,   forces of multipliers: y2 += G lambda,   flexibility F = G^T G.

#include <Eigen/Core>
#include <span>
#include <utility>

#include "creepcontact/contact/geometry/pair.hpp"
#include "creepcontact/linalg/stiffness_solver.hpp"

namespace creepcontact::contact {

/// G of one body.
class CondensedRows {
 public:
  CondensedRows() = default;
  /// @param rows  B on all free dofs, with entries at trailing dofs only
  /// @param trailing  free dofs that `factor` eliminates last, in its order
  /// Cost: trailing.size()^2 x rows.rows() + trailing.size() x rows.rows()^2 operations.
  /// @param by_factor  products with G by L22 and B: cheaper if there are more than half as many rows as trailing dofs
  CondensedRows(const RowMatrix& rows, std::span<const std::int64_t> trailing, const linalg::StiffnessSolver& factor,
                bool by_factor = false);

  /// F, rows.rows() square; computed by the constructor. May be taken once.
  Eigen::MatrixXd take_flexibility() { return std::move(flexibility_); }
  /// G^T y2. @param y  on all free dofs, in the order of the factor
  Eigen::VectorXd gaps(std::span<const double> y) const;
  /// y2 += G multiplier. @param y  as in gaps()
  void add_forces(const Eigen::VectorXd& multiplier, std::span<double> y) const;

 private:
  Eigen::MatrixXd flexibility_;
  Eigen::MatrixXd traces_;            // G, trailing.size() x rows.rows(), or empty
  Eigen::MatrixXd factor_;            // in its place L22 ...
  Eigen::SparseMatrix<double> rows_;  // ... and B^T, trailing.size() x rows.rows()
};

}  // namespace creepcontact::contact
