#pragma once
/// Random condensed contact problems, and what a solution must fulfil.

#include <gtest/gtest.h>

#include <random>

#include "creepcontact/contact/solver/contact_solver.hpp"

namespace creepcontact::test {

using contact::ContactLoad;
using contact::ContactProblem;
using contact::ContactState;

Eigen::MatrixXd random_flexibility(int n, std::mt19937& generator, double scale);

/// Chain of bodies: pair k lies between body k and k + 1, slave first.
/// @param n_floating  the last so many bodies are held by contact alone, each by its two motions
ContactProblem chain(int n_pairs, int rows_per_pair, double stiffness_ratio, std::mt19937& generator,
                     int n_floating = 0);

/// Gives some unilateral nodes gaskets with toes, plateaus and stiff pieces. @returns a load with the curves alone
/// @param stiffness  about, of their pieces @param share  of the nodes
ContactLoad add_gaskets(ContactProblem& problem, std::mt19937& generator, double stiffness, double share);
/// @param error  of the pressure
void expect_on_curve(const contact::ContactNode& node, const contact::ClosureCurve& curve, double gap, double pressure,
                     double error);

void expect_solved(const ContactProblem& problem, const ContactLoad& load, const ContactState& state, double tolerance);

/// Two bodies with as many nodes with friction between them.
/// @param n_tangents  1 or 2 @param coupling  flexibility between normal and tangential rows, 0 to 1
/// @param floating  the second body is held by contact alone: rigid-body modes along the normal and the tangents
ContactProblem frictional(int n_nodes, int n_tangents, double coupling, std::mt19937& generator, bool floating = false);

/// Conditions of friction problems: complementarity, cone, direction of the slip (towards the mean direction where
/// load.friction.direction is given), balance. @param tolerance  of the multipliers, relative to the largest
void expect_friction_solved(const ContactProblem& problem, const ContactLoad& load, const ContactState& state,
                            double tolerance);

}  // namespace creepcontact::test
