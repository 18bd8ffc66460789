#pragma once
/// All contact pairs condensed onto their multipliers: rows and loads, flexibility, and the balance of the loads.

#include <functional>
#include <limits>
#include <span>

#include "creepcontact/base/index.hpp"
#include "creepcontact/base/team.hpp"
#include "creepcontact/contact/interface_flexibility.hpp"
#include "creepcontact/contact/interface_rows.hpp"
#include "creepcontact/contact/load_balance.hpp"

namespace creepcontact::contact {

/// The condensed contact problem of all bodies, and their factors. Use from one thread at a time.
class CondensedInterface {
 public:
  /// Called between analysis and factorisation, when the sizes of all factors are known but their memory is not yet
  /// allocated. It may throw to refuse the model. @param dense_bytes  size of the dense matrices that will be made
  using Admission = std::function<void(const CondensedInterface& analyzed, double dense_bytes)>;
  /// Factors every body with its contact dofs last and condenses the contact rows.
  /// @param bodies, pairs (numbered), rigid_body_modes (of both)  must outlive the object
  /// @param at  conditions of all bodies, whose stiffness is factored
  /// @param dense_bytes  bound on the dense matrices, in bytes; beyond it the flexibility is an operator
  /// @param team  the processes that share the bodies, and their solvers; must outlive the object. Only its member 0
  /// has the dense matrices (InterfaceFlexibility::is_here())
  /// @throws ModelError as FactoredBody::factorize and RigidBodyModes::require_contact
  /// Cost: that of InterfaceFlexibility::factorize().
  CondensedInterface(std::span<const mechanics::Body> bodies, std::span<const Pair> pairs,
                     const RigidBodyModes& rigid_body_modes, InterfaceRows::Conditions at,
                     double dense_bytes = unbounded, const Admission& admit = {},
                     const linalg::StiffnessSolverFactory& make_solver = linalg::default_stiffness_solver,
                     const Team& team = serial_team());
  CondensedInterface(const CondensedInterface&) = delete;
  CondensedInterface& operator=(const CondensedInterface&) = delete;
  static constexpr double unbounded = std::numeric_limits<double>::infinity();

  const InterfaceRows& rows() const { return rows_; }
  InterfaceFlexibility& flexibility() { return flexibility_; }
  const InterfaceFlexibility& flexibility() const { return flexibility_; }
  LoadBalance& balance() { return balance_; }
  const LoadBalance& balance() const { return balance_; }

  // What most callers need of these.
  std::span<const Pair> pairs() const { return rows_.pairs(); }
  Index n_rows() const { return rows_.n_rows(); }
  const ContactProblem& problem() const { return flexibility_.problem(); }
  mechanics::FactoredBody& factored(std::size_t body) { return flexibility_.factored(body); }
  const mechanics::FactoredBody& factored(std::size_t body) const { return flexibility_.factored(body); }
  bool is_condensed() const { return flexibility_.is_condensed(); }
  bool is_dense() const { return flexibility_.is_dense(); }
  double dense_bytes() const { return flexibility_.dense_bytes(); }
  double error_bound() const { return flexibility_.error_bound(); }

 private:
  InterfaceRows rows_;
  InterfaceFlexibility flexibility_;
  LoadBalance balance_;
};

}  // namespace creepcontact::contact
