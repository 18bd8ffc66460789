#pragma once
/// The flexibility of the contact rows. K = L L^T is factored with the contact dofs of each body last. Let B be the
/// rows of the weighted gaps of a body, and L22 the trailing block of L. Then G = L22^-1 B^T contains all that contact
/// needs:
///   y = L^-1 f,   gap = initial gap + G^T y2,   contact forces: y2 += G lambda,   u = L^-T y,   F = G^T G.
/// Contact therefore needs no substitutions of its own.
///
/// If the dense matrices would exceed a bound, the bodies are factored without this ordering: G = L^-1 P B^T is applied
/// by additional substitutions, and a product with F costs one forward and one back substitution.
/// Solvers without a factor are used in the same way, with L = I and G = B^T; within the bound on dense matrices, F is
/// then computed column by column.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "creepcontact/base/team.hpp"
#include "creepcontact/contact/condensed_rows.hpp"
#include "creepcontact/contact/interface_rows.hpp"
#include "creepcontact/contact/solver/problem.hpp"
#include "creepcontact/mechanics/factored_body.hpp"

namespace creepcontact::contact {

class FactoredFlexibility;

/// The factors of all bodies, and the contact problem with the flexibilities that follow from them: dense from the
/// trailing dofs of the factors (is_condensed()), dense from a solve per row (is_dense() alone), or an operator.
class InterfaceFlexibility {
 public:
  using Conditions = InterfaceRows::Conditions;

  /// Analyses the bodies; problem() has no flexibilities yet.
  /// @param bodies, rows, team  must outlive the object @param at  conditions of all bodies
  /// @param dense_bytes  bound on the dense matrices, in bytes; beyond it the flexibility is an operator
  /// @throws ConfigError if the bound excludes dense matrices and the team has several members
  InterfaceFlexibility(std::span<const mechanics::Body> bodies, const InterfaceRows& rows, Conditions at,
                       double dense_bytes, const linalg::StiffnessSolverFactory& make_solver, const Team& team);
  ~InterfaceFlexibility();

  /// Factors all bodies with the stiffness of these conditions. Call it once, before all that follows.
  /// @throws ModelError as FactoredBody::factorize
  /// Cost: the factorisations, and n_contact^2 x n_rows operations per body.
  void factorize(Conditions at);
  /// Factors and condenses these bodies again, with the stiffness of these conditions. The caller must then call
  /// flexibility_changed() of all contact solvers and systems that use problem(). Cost: as factorize().
  void refactorize(std::span<const std::size_t> bodies, Conditions at);

  mechanics::FactoredBody& factored(std::size_t body) { return factored_[body]; }
  const mechanics::FactoredBody& factored(std::size_t body) const { return factored_[body]; }
  const ContactProblem& problem() const { return problem_; }
  /// See immovable_rows(); of the first factors.
  const std::vector<int>& immovable() const { return immovable_; }

  /// True if contact is condensed onto the trailing dofs of the bodies' factors.
  bool is_condensed() const { return is_condensed_; }
  /// False if the flexibility is an operator, because the dense matrices would exceed the bound.
  bool is_dense() const { return is_dense_; }
  /// Bytes that the dense matrices of the interface take, or would take if !is_dense().
  double dense_bytes() const { return dense_bytes_; }
  /// True in the process that has the dense matrices, and solves the contact problem for all. In the others problem()
  /// has nodes and rigid-body modes, but no flexibilities, and add_trace() and add_multipliers() do nothing.
  bool is_here() const { return team_.rank() == 0; }
  /// Largest error bound of the bodies' solvers; 0 if all are direct.
  double error_bound() const;
  /// Products with F so far, each one forward and one back substitution of all bodies; 0 if is_dense().
  std::int64_t n_products() const;

  /// gap += G^T y2. @param y  L^-1 P f on all free dofs of the body
  void add_trace(std::size_t body, std::span<const double> y, Eigen::VectorXd& gap);
  /// y2 += G lambda. May run for several bodies at once.
  void add_multipliers(std::size_t body, const Eigen::VectorXd& multiplier, std::span<double> y);

 private:
  void factorize_bodies(std::span<const std::size_t> bodies, Conditions at);
  void condense(std::span<const std::size_t> bodies);
  void solve_for_flexibility(std::size_t body);
  void sum_flexibilities();
  void make_operator(Conditions at);

  const InterfaceRows& rows_;
  const Team& team_;
  std::vector<mechanics::FactoredBody> factored_;
  std::vector<CondensedRows> condensed_;  // per body; empty if !is_condensed()
  double dense_bytes_ = 0;
  bool is_condensed_ = false, is_dense_ = false;
  ContactProblem problem_;
  std::vector<int> immovable_;  // rows
  std::unique_ptr<FactoredFlexibility> large_;
  std::int64_t earlier_products_ = 0;  // of operators replaced by refactorize()
};

}  // namespace creepcontact::contact
