#pragma once
/// The flexibility F of all bodies as an operator, for contact zones that are too large for dense matrices.

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace creepcontact::contact {

/// Approximate inverse of F on one set of rows: multipliers that approximately close given gaps.
class Preconditioner {
 public:
  virtual ~Preconditioner() = default;
  /// @param gaps  one per row of the set @returns one per row of the set
  virtual Eigen::VectorXd multipliers(const Eigen::VectorXd& gaps) const = 0;
};

/// Symmetric positive semidefinite.
class FlexibilityOperator {
 public:
  virtual ~FlexibilityOperator() = default;
  /// F multiplier, on all rows. Cost: one forward and one back substitution per body.
  virtual Eigen::VectorXd gaps(const Eigen::VectorXd& multiplier) const = 0;
  /// Estimate of the diagonal of F; each entry is positive if its row can move.
  virtual const Eigen::VectorXd& diagonal() const = 0;
  /// A preconditioner of F with a compliance added to its diagonal. The operator must outlive the result.
  /// @param set  rows, ascending @param compliance  one per row of the set, at least 0
  virtual std::unique_ptr<Preconditioner> preconditioner(const std::vector<int>& set,
                                                         const Eigen::VectorXd& compliance) const = 0;
};

}  // namespace creepcontact::contact
