#pragma once
/// Whether contact with friction has one solution only.

#include <optional>

#include "creepcontact/contact/solver/problem.hpp"

namespace creepcontact::contact {

/// The spectral radius kappa of mu |F_nn^-1 F_nt| over the nodes in contact: by how much a change of the shear
/// tractions can change the limits of the shear tractions through the pressures. In all cases tried, the solution is
/// unique for kappa < 1. Above 1 several states of stick and slip may be possible (a wedge that locks has kappa > 1),
/// and which one the bodies are in depends on how they were loaded.
/// @param friction  of the same time as `at`
/// @returns nullopt without friction in contact, and if the flexibility is an operator
/// Cost: a Cholesky factorisation and a triangular solve for all tangential rows.
std::optional<double> friction_kappa(const ContactProblem& problem, const Friction& friction, const ContactState& at);

}  // namespace creepcontact::contact
