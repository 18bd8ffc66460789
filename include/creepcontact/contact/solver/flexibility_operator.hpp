#pragma once
/// The bodies' flexibility as an operator, for contact zones too large for dense matrices.

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace creepcontact::contact {

/// Approximates the multipliers that close given gaps on one set of rows.
class Preconditioner {
 public:
  virtual ~Preconditioner() = default;
  virtual Eigen::VectorXd multipliers(const Eigen::VectorXd& gaps) const = 0;
};

class FlexibilityOperator {
 public:
  virtual ~FlexibilityOperator() = default;
  /// F lambda on all rows.
  virtual Eigen::VectorXd gaps(const Eigen::VectorXd& multiplier) const = 0;
  /// An estimate of diag F, each entry positive where bodies can move.
  virtual const Eigen::VectorXd& diagonal() const = 0;
  /// @param set  rows, ascending; the operator must outlive the result
  virtual std::unique_ptr<Preconditioner> preconditioner(const std::vector<int>& set) const = 0;
};

}  // namespace creepcontact::contact
