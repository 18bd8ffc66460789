#pragma once
/// Solvers of the condensed contact problem: the alternating Schwarz iteration and the active-set method.

#include <memory>
#include <optional>
#include <vector>

#include "creepcontact/contact/solver/fixed_point_solver.hpp"
#include "creepcontact/contact/solver/iteration_recorder.hpp"
#include "creepcontact/contact/solver/problem.hpp"

namespace creepcontact::contact {

class ContactSolver {
 public:
  virtual ~ContactSolver() = default;
  /// @param warm  state to start from; changes the cost, and the result by less than the tolerance
  /// @throws UnbalancedLoad if bodies held by contact alone fly off; SolverError if no consistent contact state is
  /// found
  virtual ContactResult solve(const ContactLoad& load, const ContactState& warm) = 0;
  /// The flexibilities of the problem are others than before: what was made of them must be made anew.
  virtual void flexibility_changed() = 0;
  /// Who is told of every iteration from now on; null: nobody. @param recorder must outlive its use
  virtual void set_recorder(IterationRecorder* recorder) = 0;
  /// True once sweeps have failed to converge and are not tried again: all that solves to come depend on, warm apart.
  virtual bool has_given_up_sweeps() const { return false; }
  /// As if they had failed already.
  virtual void give_up_sweeps() {}
};

/// Parameters of the alternating Schwarz iteration; defaults as in the configuration.
struct SchwarzOptions {
  enum class Acceleration { none, aitken, anderson, cg };
  /// The article's constant of each body; no number, or no entry: weights from the flexibilities.
  std::vector<std::optional<double>> alpha = {};
  double damping = 1.0;  ///< part of each sweep that is taken, in (0, 1]
  Acceleration acceleration = Acceleration::cg;
  double tolerance = 1e-10;         ///< error of the multipliers relative to the largest one
  int max_iterations = 200;         ///< in one solve on a frozen set
  FixedPointFactory anderson = {};  ///< Anderson's method, needed for this acceleration
};

/// Primal-dual active set (Hintermueller, Ito and Kunisch 2003) with direct solves. If the sets cycle: Murty's
/// least-index rule, which ends for every positive definite problem; rigid motions are then held by springs whose force
/// is iterated away (method of multipliers, Hestenes 1969). @param problem must outlive the solver
std::unique_ptr<ContactSolver> active_set_solver(const ContactProblem& problem);

/// Alternating Schwarz with a frozen active set inside and its update outside. Sets that cannot balance the loads of
/// bodies held by contact alone are replaced by those that springs find. Falls back, with one warning each, to
/// conjugate gradients when sweeps do not converge and to the active-set method when the sets cycle.
/// @param problem must outlive the solver
/// @throws std::invalid_argument if Anderson's method is asked for and not handed over
std::unique_ptr<ContactSolver> schwarz_solver(const ContactProblem& problem, const SchwarzOptions& options);

}  // namespace creepcontact::contact
