#pragma once
/// Displacements of all bodies for nodal forces, with the set of closed contacts held fixed: forward through the
/// factors, contact, backward. The elastic linearisation and the tangent systems share it.

#include <functional>
#include <span>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/base/stopwatch.hpp"
#include "creepcontact/contact/solver/problem.hpp"
#include "creepcontact/linalg/stiffness_solver.hpp"

namespace creepcontact::creep {

/// One body's part.
struct FactoredSide {
  linalg::StiffnessSolver* solver = nullptr;  ///< nullptr: the body takes no part
  std::span<double> free;                     ///< n_free: forces without resultants, replaced by the displacement
};

/// @param for_each_factor  as EquilibriumSolver::for_each_factor()
/// @param contact  add_trace(body, y, gap), close(gap) -> ContactState, add_multipliers(body, multiplier, y)
template <typename ForEachFactor, typename Contact>
contact::ContactState fixed_contact_solve(std::span<const FactoredSide> sides, Index n_rows,
                                          const ForEachFactor& for_each_factor, Contact& contact, Stopwatch& watch) {
  for_each_factor([&](std::size_t b) {
    if (sides[b].solver != nullptr) sides[b].solver->forward(sides[b].free, sides[b].free);
  });
  contact::ContactState change;
  {
    const auto lap = watch.lap(Part::contact);
    Eigen::VectorXd gap = Eigen::VectorXd::Zero(n_rows);
    for (std::size_t b = 0; b < sides.size(); ++b)
      if (sides[b].solver != nullptr) contact.add_trace(b, sides[b].free, gap);
    if (n_rows > 0) change = contact.close(gap);
    for (std::size_t b = 0; b < sides.size(); ++b)
      if (sides[b].solver != nullptr) contact.add_multipliers(b, change.multiplier, sides[b].free);
  }
  for_each_factor([&](std::size_t b) {
    if (sides[b].solver != nullptr) sides[b].solver->backward(sides[b].free, sides[b].free);
  });
  return change;
}

}  // namespace creepcontact::creep
