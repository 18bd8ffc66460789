#pragma once
/// F = sum over bodies of B K^-1 B^T, applied by forward and backward passes through the bodies' factors.

#include <cstdint>
#include <span>

#include "creepcontact/contact/body_rows.hpp"
#include "creepcontact/contact/solver/flexibility_operator.hpp"
#include "creepcontact/mechanics/factored_body.hpp"

namespace creepcontact::contact {

/// Preconditioner: the slave's "lumped" Dirichlet half-sweep of Farhat and Roux (1991), D^-1 B K B^T D^-1 with D = B
/// B^T, which lets only the contact surface itself move: sparse, and within a modest factor of the true one. With a
/// compliance C it is (F + C)^-1 for F = D (B K B^T)^-1 D, by Woodbury's formula C^-1 - C^-1 D (B K B^T + D C^-1 D)^-1
/// D C^-1.
class FactoredFlexibility final : public FlexibilityOperator {
 public:
  /// @param bodies  factored, with any ordering @param at  conditions that were factored
  /// bodies and rows must outlive the object
  FactoredFlexibility(std::span<mechanics::FactoredBody> bodies, std::span<const mechanics::BodyConditions> at,
                      const std::vector<BodyRows>& rows, int n_rows);
  ~FactoredFlexibility() override;

  Eigen::VectorXd gaps(const Eigen::VectorXd& multiplier) const override;
  const Eigen::VectorXd& diagonal() const override { return diagonal_; }
  std::unique_ptr<Preconditioner> preconditioner(const std::vector<int>& set,
                                                 const Eigen::VectorXd& compliance) const override;

  /// Calls of gaps(): each is one pass forward and backward through all factors.
  std::int64_t n_products() const { return n_products_; }

 private:
  struct Lumped;  // one body's sparse matrices on the rows where it is the slave

  std::span<mechanics::FactoredBody> bodies_;
  const std::vector<BodyRows>& rows_;
  Eigen::VectorXd diagonal_;
  std::vector<Lumped> lumped_;
  mutable std::vector<std::vector<double>> work_;  // n_free, of every body
  mutable std::int64_t n_products_ = 0;
};

}  // namespace creepcontact::contact
