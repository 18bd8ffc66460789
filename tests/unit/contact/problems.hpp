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

void expect_solved(const ContactProblem& problem, const ContactLoad& load, const ContactState& state, double tolerance);

}  // namespace creepcontact::test
