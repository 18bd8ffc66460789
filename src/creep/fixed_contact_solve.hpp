#pragma once
/// Displacements of all bodies for nodal forces, with the set of closed contacts held fixed: forward through the
/// factors, contact, backward. The elastic linearisation and the tangent systems share it.

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

/// @param contact  add_trace(body, y, gap), close(gap) -> ContactState, add_multipliers(body, multiplier, y)
template <typename Contact>
contact::ContactState fixed_contact_solve(std::span<const FactoredSide> sides, Index n_rows, Contact& contact,
                                          Stopwatch& watch) {
  std::vector<linalg::Substitution> substitutions;
  for (const FactoredSide& side : sides)
    if (side.solver != nullptr) substitutions.push_back({side.solver, side.free, side.free});
  {
    const auto lap = watch.lap(Part::solve);
    linalg::forward(substitutions);
  }
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
  const auto lap = watch.lap(Part::solve);
  linalg::backward(substitutions);
  return change;
}

}  // namespace creepcontact::creep
