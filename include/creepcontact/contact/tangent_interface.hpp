#pragma once
/// The contact rows condensed with factors of other stiffnesses of the bodies than the elastic ones: those of a Newton
/// iteration, in which the rows that are in contact stay closed and no other row matters.

#include <span>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/condensed_interface.hpp"
#include "creepcontact/contact/condensed_rows.hpp"
#include "creepcontact/contact/solver/frozen_system.hpp"

namespace creepcontact::contact {

class TangentInterface {
 public:
  /// @param interface  must be dense
  /// @param factors    one a body, with the pattern and the trailing unknowns of the body's own; nullptr for a body
  /// with
  ///                   its elastic stiffness
  /// @param elastic_scale  what the flexibilities of the interface are multiplied with for bodies without a factor
  /// Cost: n_trailing^2 x n_rows operations a factor.
  TangentInterface(const CondensedInterface& interface, std::span<const linalg::StiffnessSolver* const> factors,
                   double elastic_scale = 1);
  TangentInterface(const TangentInterface&) = delete;
  TangentInterface& operator=(const TangentInterface&) = delete;

  Index n_rows() const { return problem_.n_rows(); }
  /// gap (n_rows) += G^T y2. @param y  L^-1 P f of a body with a factor, all free unknowns
  void add_trace(std::size_t body, std::span<const double> y, Eigen::VectorXd& gap) const;
  /// Multipliers and rigid motions that close the gaps of these rows. The forces that opened the gaps have no
  /// resultants. Cost: as FrozenSystem::solve. @throws SolverError if the rows contradict each other
  ContactState close(const std::vector<int>& active, const Eigen::VectorXd& gap);
  /// y2 += G lambda
  void add_multipliers(std::size_t body, const Eigen::VectorXd& multiplier, std::span<double> y) const;

 private:
  const CondensedInterface& interface_;
  std::vector<CondensedRows> condensed_;  // of bodies with a factor
  ContactProblem problem_;
  FrozenSystem frozen_;
};

}  // namespace creepcontact::contact
