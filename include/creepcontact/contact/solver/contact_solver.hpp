#pragma once
/// Solvers of the condensed contact problem: the alternating Schwarz iteration and the active-set method.

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "creepcontact/base/stop_request.hpp"
#include "creepcontact/contact/solver/fixed_point_solver.hpp"
#include "creepcontact/contact/solver/iteration_recorder.hpp"
#include "creepcontact/contact/solver/problem.hpp"
#include "creepcontact/settings/contact_settings.hpp"

namespace creepcontact::contact {

/// Solves the complementarity problem of ContactProblem for one load. Use from one thread at a time.
class ContactSolver {
 public:
  virtual ~ContactSolver() = default;
  /// @param warm  state to start from; it affects the cost, and the result by less than the tolerance
  /// @throws UnbalancedLoad if the loads push away bodies that only contact holds; SolverError if no consistent contact
  /// state is found; Cancelled if the end is requested
  virtual ContactResult solve(const ContactLoad& load, const ContactState& warm) = 0;
  /// Must be called when the flexibilities of the problem have changed: discards what was computed from them.
  virtual void flexibility_changed() = 0;
  /// Sets the receiver of all later iterations; null: none. @param recorder  must outlive its use
  virtual void set_recorder(IterationRecorder* recorder) = 0;
  /// Sets the request that all later iterations heed.
  virtual void set_stop(const StopRequest& stop) = 0;
  /// True after Schwarz sweeps have failed to converge; they are then not tried again. Later solves depend on this
  /// only, apart from their arguments.
  virtual bool has_given_up_sweeps() const { return false; }
  /// Makes has_given_up_sweeps() true, as if they had failed.
  virtual void give_up_sweeps() {}
};

/// Makes a solver for a problem, which must outlive it.
using ContactSolverFactory = std::function<std::unique_ptr<ContactSolver>(const ContactProblem&)>;

/// Solver for problems with gaskets: Newton's method on the closures. Each iteration is a contact problem in which the
/// curves are straight lines, so that their compliance is part of F; without friction the steps go to the least energy
/// between the iterates, which converges from any start. Without gaskets: make_solver(problem).
/// @param problem  must outlive the solver @param make_solver  of the iterations
/// Cost: one solve by make_solver() while no node passes to another piece of its curve, which changes F.
std::unique_ptr<ContactSolver> gasket_solver(const ContactProblem& problem, const ContactSolverFactory& make_solver);

/// Parameters of the alternating Schwarz iteration.
struct SchwarzOptions {
  using Acceleration = settings::Acceleration;
  /// Constant alpha of each body (Stankevich); if absent, the weights follow from the flexibilities.
  std::vector<std::optional<double>> alpha = {};
  double damping = settings::ContactSettings{}.damping;  ///< relaxation factor of each sweep, in (0, 1]
  Acceleration acceleration = settings::ContactSettings{}.acceleration;
  double tolerance = settings::ContactSettings{}.tolerance;  ///< error of the multipliers relative to the largest one
  int max_iterations = settings::ContactSettings{}.max_iterations;  ///< per solve with one active set
  FixedPointFactory anderson = {};                                  ///< Anderson's method, needed for this acceleration
};

/// Primal-dual active set method (Hintermueller, Ito and Kunisch 2003) with direct solves. If the sets cycle, Murty's
/// least-index rule takes over, which terminates for every positive definite problem. Added springs, whose force is
/// iterated to zero, then hold rigid-body modes (method of multipliers, Hestenes 1969).
/// @param problem  must outlive the solver
std::unique_ptr<ContactSolver> active_set_solver(const ContactProblem& problem);

/// Alternating Schwarz iteration on a fixed active set, with updates of the set around it. A set that cannot balance
/// the loads of bodies held by contact alone is replaced by one found with springs (see active_set_solver). Falls back,
/// with one warning each, to conjugate gradients if the sweeps do not converge and to the active-set method if the sets
/// cycle.
/// @param problem  must outlive the solver
/// @throws std::invalid_argument if Anderson's method is chosen but options.anderson is empty
std::unique_ptr<ContactSolver> schwarz_solver(const ContactProblem& problem, const SchwarzOptions& options);

/// Parameters of the solver of contact with friction.
struct FrictionOptions {
  settings::FrictionMethod method = settings::ContactSettings{}.friction;
  /// Options of the Schwarz iteration, which solves Tresca's law; all methods use its tolerance.
  SchwarzOptions schwarz = {};
};

/// Solver for problems with any mixture of unilateral, tied and frictional nodes.
/// - newton: semismooth Newton method with line search. Bodies held by contact alone: proximal iterations around it
///   (method of multipliers). Where it fails, Tresca's law gives it another start.
/// - tresca: frozen tractions of slipping nodes, iterated; the equations of sticking and closed rows by the Schwarz
///   iteration, whose sweeps exchange tangential tractions too. Where it fails, Newton takes over, with one warning.
/// Both stop at the same tolerance.
/// Source: Alart and Curnier (1991); Hueeber, Stadler and Wohlmuth (2008); Gitterle et al. (2010).
/// @param problem  must outlive the solver
/// @throws std::invalid_argument as schwarz_solver()
std::unique_ptr<ContactSolver> friction_solver(const ContactProblem& problem, const FrictionOptions& options);

}  // namespace creepcontact::contact
