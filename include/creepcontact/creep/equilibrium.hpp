#pragma once
/// What one elastic solve gives, and what accepted steps leave behind for the solves to come: plain values.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "creepcontact/contact/solver/problem.hpp"
#include "creepcontact/mechanics/body_conditions.hpp"

namespace creepcontact::creep {

/// Mechanical state of one body.
struct BodyState {
  std::vector<double> displacement;  ///< 3 n_nodes
  std::vector<double> stress;        ///< n_points x 6, Mandel order
};

/// Displacement of a body as its factor sees it: y = L^T u, and u on the free unknowns. Empty: u = 0.
struct FactoredDisplacement {
  std::vector<double> factored, free;  ///< n_free
};

/// Elastic equilibrium of all bodies in contact at one time. Owned by the caller of EquilibriumSolver::solve(), which
/// reuses its memory; nothing in it refers to the solver.
struct Equilibrium {
  double time = 0;
  std::vector<mechanics::BodyConditions> conditions;  ///< one per body
  std::vector<BodyState> bodies;
  contact::ContactState contact;  ///< multipliers (contact pressures), rigid motions, rows in contact (ascending)
  Eigen::VectorXd gaps;           ///< weighted, of all contact rows
  double stiffness_scale = 1;     ///< stiffness at this time over that of the factors
  std::vector<FactoredDisplacement> displacements;  ///< one per body if the stiffness changes in time
  std::int64_t factors = 0;                         ///< of which factorisation those are
};

/// What evaluations depend on besides their arguments: accepted steps alone change it, and checkpoints store it.
struct History {
  contact::ContactState contact;  ///< of the last accepted step, where contact iterations start
  struct Accepted {
    double time = 0;
    std::vector<FactoredDisplacement> displacements;
    std::int64_t factors = 0;
  };
  std::vector<Accepted> accepted;         ///< if the stiffness changes: the last two steps, the last one first
  std::vector<std::int64_t> set_changes;  ///< per pair: steps after which other nodes were in contact than before
};

/// Named numbers of a checkpoint.
using Memory = std::map<std::string, std::vector<double>>;

}  // namespace creepcontact::creep
