#pragma once
/// Whether supports and contact can balance the external forces. Only the rigid-body modes and the directions of the
/// contact rows matter, so nothing is factored.

#include <span>
#include <vector>

#include "creepcontact/base/error.hpp"
#include "creepcontact/contact/geometry/pair.hpp"
#include "creepcontact/contact/interface_rows.hpp"
#include "creepcontact/contact/rigid_body_modes.hpp"
#include "creepcontact/contact/solver/problem.hpp"
#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::contact {

/// The multiplier nodes of a pair, with the tractions that they admit.
void add_nodes(const Pair& pair, ContactProblem& problem);

/// The loads move a body that only contact with friction holds. Within a run a smaller step may avoid it.
class SlidingOff : public ModelError {
 public:
  using ModelError::ModelError;
};

/// Checks the loads of an interface on their way to the contact solver.
class LoadBalance {
 public:
  /// @param rows, immovable (see InterfaceFlexibility)  must outlive the object
  LoadBalance(const InterfaceRows& rows, const std::vector<int>& immovable) : rows_(rows), immovable_(immovable) {}

  /// The load in the form the contact solver takes. Warns once if, along an unconstrained mode, the loads are out of
  /// balance by more than 1e-8 of the sum of the forces, as on meshes that are not quite symmetric; and once of
  /// surfaces that supports hold where they overlap.
  /// @throws ModelError if the loads are out of balance by more than 1e-4
  ContactLoad contact_load(const InterfaceLoad& load);
  /// @throws ModelError naming the bodies and the motion along which the loads drive them; SlidingOff if the problem
  /// has friction
  [[noreturn]] void report(const UnbalancedLoad& unbalanced, double t) const;

 private:
  void warn_of_held_overlaps(const InterfaceLoad& load);

  const InterfaceRows& rows_;
  const std::vector<int>& immovable_;
  bool residual_warned_ = false, overlap_warned_ = false;
};

/// Refuses loads at time t that no pressures can balance, as the contact solvers do. What friction can hold is not
/// judged: then only the unconstrained modes are.
/// @param pairs  with numbered rows @param at  conditions of all bodies at time t
/// @throws ModelError with the motion that nothing prevents
/// Cost: sparse products with the contact rows, and a non-negative least-squares problem in the modes.
void require_balance(std::span<const mechanics::Body> bodies, std::span<const Pair> pairs, const RigidBodyModes& modes,
                     std::span<const mechanics::BodyConditions> at, double t);

}  // namespace creepcontact::contact
