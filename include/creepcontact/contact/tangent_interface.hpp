#pragma once
/// The contact rows condensed with stiffnesses other than the elastic ones, as in a Newton iteration. Closed rows stay
/// closed, open rows do not matter, and nodes that slip or stick go on to do so.

#include <span>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/condensed_interface.hpp"
#include "creepcontact/contact/condensed_rows.hpp"
#include "creepcontact/contact/solver/active_set_system.hpp"

namespace creepcontact::contact {

/// Flexibility of all rows for one set of tangent factors.
class TangentInterface {
 public:
  /// @param interface  must be dense and outlive the object
  /// @param factors  one per body, with the pattern and the trailing dofs of its elastic factor; nullptr for a body
  /// with elastic stiffness. Not used after construction.
  /// @param elastic_scale  factor applied to the flexibilities of bodies without a factor
  /// Cost: n_trailing^2 x n_rows operations per factor.
  TangentInterface(const CondensedInterface& interface, std::span<const linalg::StiffnessSolver* const> factors,
                   double elastic_scale = 1);
  TangentInterface(const TangentInterface&) = delete;
  TangentInterface& operator=(const TangentInterface&) = delete;

  /// Contact rows of all pairs.
  Index n_rows() const { return problem_.n_rows(); }
  /// gap (n_rows) += G^T y2. @param y  L^-1 P f on all free dofs of a body that has a factor
  void add_trace(std::size_t body, std::span<const double> y, Eigen::VectorXd& gap) const;
  /// Multipliers and amplitudes of the rigid-body modes that close the gaps of the rows closed in a state, with its
  /// friction. The forces that opened the gaps have no resultants.
  /// Cost: as ActiveSetSystem::solve. @throws SolverError if the rows contradict each other
  ContactState close(const ContactState& at, const Eigen::VectorXd& gap);
  /// y2 += G lambda
  void add_multipliers(std::size_t body, const Eigen::VectorXd& multiplier, std::span<double> y) const;

 private:
  const CondensedInterface& interface_;
  std::vector<CondensedRows> condensed_;  // of bodies with a factor; else empty
  ContactProblem problem_;
  ActiveSetSystem active_set_;
};

}  // namespace creepcontact::contact
