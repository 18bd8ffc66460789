#pragma once
/// The linear equations of contact with a given active set I:
///   F_II lambda_I + N_I alpha = -gap_I,   N_I^T lambda_I = -resultant
/// F_II may be singular at the fixing dofs of bodies held by contact alone. F_II + c N_I N_I^T is regular; using it
/// instead changes the amplitudes by c N_I^T lambda only.

#include <Eigen/Cholesky>
#include <memory>
#include <vector>

#include "creepcontact/base/stop_request.hpp"
#include "creepcontact/contact/solver/problem.hpp"

namespace creepcontact::contact {

/// Solution with the gaps of the active set closed.
struct ActiveSetSolution {
  ContactState state;  ///< multipliers n_rows, zero outside the set
  /// False if the set cannot balance the resultants (too few contacts for the loads).
  bool balanced = true;
};

class FrictionSystem;
class ProjectedCg;

/// Solver for ContactProblem with given active sets; keeps the factor of the last set.
class ActiveSetSystem {
 public:
  /// @param problem  must outlive the object
  /// @param tolerance  relative, of the multipliers; used only where the flexibility is an operator
  explicit ActiveSetSystem(const ContactProblem& problem, double tolerance = 1e-10);
  ~ActiveSetSystem();

  /// Closes the gaps of the set. Rigid-body modes that the set does not hold keep the amplitude 0.
  /// Cost: two triangular solves of the size of the set, and a Cholesky factorisation if the set differs from the last
  /// one; conjugate gradients if the flexibility is an operator.
  /// @param active  rows, ascending
  /// @throws SolverError if the conditions of the set contradict or repeat each other, or the iteration does not
  /// converge
  ActiveSetSolution solve(const std::vector<int>& active, const ContactLoad& load);
  /// Change of the multipliers and amplitudes for a change of the gaps near a state: closed rows stay closed, and nodes
  /// with friction fulfil the equations of `at.nodes`; gaskets have `at.compliance`. No resultants change.
  /// Cost: as solve(); with friction a few products with F, see FrictionSystem.
  /// @param gap  in rows of gaskets with what opens by itself, such as creep of the gasket
  /// @param at  its multipliers do not matter @throws SolverError as solve()
  ContactState solve_change(const ContactState& at, const Eigen::VectorXd& gap);
  /// Must be called when the flexibilities of the problem have changed.
  void flexibility_changed();
  /// Sets the request that all later iterations heed: solve() and solve_change() then throw Cancelled.
  void set_stop(const StopRequest& stop);

 private:
  ContactState change(const ContactState& at, const Eigen::VectorXd& gap);
  void factorize(const std::vector<int>& active);
  ActiveSetSolution solve_directly(const ContactLoad& load);
  ActiveSetSolution solve_iteratively(const std::vector<int>& active, const ContactLoad& load);

  const ContactProblem& problem_;
  double tolerance_;
  StopRequest stop_;
  struct WithGaskets;
  std::unique_ptr<WithGaskets> gaskets_;      // for the last compliance
  std::unique_ptr<FrictionSystem> friction_;  // made when first needed
  std::unique_ptr<ProjectedCg> cg_;           // if the flexibility is an operator
  std::vector<int> active_;
  bool factored_ = false;
  double fixing_flexibility_ = 0;       // c
  Eigen::LLT<Eigen::MatrixXd> factor_;  // F_II + c N_I N_I^T = L L^T
  Eigen::MatrixXd motions_;             // L^-1 N_I
  Eigen::MatrixXd coarse_inverse_;      // pseudo-inverse of motions_^T motions_
};

/// Cholesky factor of a flexibility that may be singular up to round-off: if necessary, the diagonal is shifted by
/// 1e-12 of its largest entry. @returns false if even the shifted matrix is not positive definite
bool factor_semidefinite(const Eigen::MatrixXd& matrix, Eigen::LLT<Eigen::MatrixXd>& factor);

}  // namespace creepcontact::contact
