#pragma once
/// Solvers of the condensed contact problem: the alternating Schwarz iteration and the active-set method.

#include <memory>
#include <optional>
#include <string>

#include "creepcontact/contact/problem.hpp"

namespace creepcontact::contact {

class ContactSolver {
 public:
  virtual ~ContactSolver() = default;
  /// @param warm  state to start from; changes the cost, and the result by less than the tolerance
  /// @throws UnbalancedLoad if bodies held by contact alone fly off; SolverError if no consistent contact state is
  /// found
  virtual ContactResult solve(const ContactLoad& load, const ContactState& warm) = 0;
};

/// Parameters of the alternating Schwarz iteration; defaults as in the configuration.
struct SchwarzOptions {
  enum class Acceleration { none, aitken, anderson, cg };
  std::optional<double> alpha = {};  ///< the article's constant for both bodies; none: weights from the flexibilities
  Acceleration acceleration = Acceleration::cg;
  double tolerance = 1e-10;  ///< error of the multipliers relative to the largest one
  int max_iterations = 200;  ///< in one solve on a frozen set
};

/// Primal-dual active set (Hintermueller, Ito and Kunisch 2003) with direct solves. If the sets cycle: Murty's
/// least-index rule, which ends for every positive definite problem; rigid motions are then held by springs whose force
/// is iterated away (method of multipliers, Hestenes 1969). @param problem must outlive the solver
std::unique_ptr<ContactSolver> active_set_solver(const ContactProblem& problem);

/// Alternating Schwarz with a frozen active set inside and its update outside. Falls back, with one warning, to
/// conjugate gradients when sweeps diverge and to the active-set method when the sets cycle.
std::unique_ptr<ContactSolver> schwarz_solver(const ContactProblem& problem, const SchwarzOptions& options);

}  // namespace creepcontact::contact
