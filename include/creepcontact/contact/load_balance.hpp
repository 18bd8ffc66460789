#pragma once
/// Whether supports and contact can balance the external forces at all. Only the rigid-body modes and the directions of
/// the contact rows count, so nothing is factored.

#include <span>
#include <string>

#include "creepcontact/contact/geometry/pair.hpp"
#include "creepcontact/contact/rigid_body_modes.hpp"
#include "creepcontact/contact/solver/problem.hpp"
#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::contact {

/// The multiplier nodes of a pair, with the tractions that they admit.
void add_nodes(const Pair& pair, ContactProblem& problem);

/// The unconstrained modes must not be loaded.
/// @param work  of the external forces on unit rigid-body modes, RigidBodyModes::size()
/// @param force  per mode: sum of the absolute external forces on its body, the scale of `work`
/// @returns a warning if the loads are out of balance by more than 1e-8 of the sum of the forces, as on meshes that are
/// not quite symmetric; else empty @throws ModelError with the motion if by more than 1e-4
std::string require_free_motions_unloaded(const RigidBodyModes& modes, const Eigen::VectorXd& work,
                                          const Eigen::VectorXd& force, double t);

/// Work on the modes that contact holds, without round-off.
Eigen::VectorXd held_resultant(const RigidBodyModes& modes, const Eigen::VectorXd& work, const Eigen::VectorXd& force);
/// The scale of that work: what the forces on the bodies would do if nothing cancelled.
Eigen::VectorXd held_force(const RigidBodyModes& modes, const Eigen::VectorXd& force);

/// @throws ModelError naming the bodies and the motion along which the loads drive them
[[noreturn]] void report_unbalanced(const RigidBodyModes& modes, const UnbalancedLoad& unbalanced, double t);

/// Refuses loads at time t that no pressures can balance, as the contact solvers do. What friction can hold is not
/// judged: then only the unconstrained modes are.
/// @param pairs  with numbered rows @param at  conditions of all bodies at time t
/// @throws ModelError as require_free_motions_unloaded() and report_unbalanced()
/// Cost: sparse products with the contact rows, and a non-negative least-squares problem in the modes.
void require_balance(std::span<const mechanics::Body> bodies, std::span<const Pair> pairs, const RigidBodyModes& modes,
                     std::span<const mechanics::BodyConditions> at, double t);

}  // namespace creepcontact::contact
