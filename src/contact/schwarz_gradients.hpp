#pragma once
/// Conjugate gradients on the equations of a frozen set, preconditioned by the slave's half of a sweep.

#include <memory>

#include "creepcontact/contact/contact_solver.hpp"
#include "dirichlet_problem.hpp"
#include "frozen_set.hpp"

namespace creepcontact::contact {

/// F_II lambda + N_I alpha = -gap and N_I^T lambda = -resultant. All iterates balance the resultants: the iteration
/// starts from multipliers that do, and the preconditioner is that of Gould, Hribar and Nocedal (2001),
///   z = M^-1 r - M^-1 Q (Q^T M^-1 Q)^-1 Q^T M^-1 r,   M: F_slave, Q: orthonormal basis of N_I,
/// for a floating slave its Dirichlet half-sweep without rigid part. alpha follows from the residual left.
class SchwarzGradients {
 public:
  SchwarzGradients(const ContactProblem& problem, const SchwarzOptions& options, std::vector<int> active);
  const std::vector<int>& active() const { return set_.active(); }
  const RigidBalance& balance() const { return set_.balance(); }
  /// @param start  multipliers on the set
  InnerResult solve(const FrozenLoad& load, const Eigen::VectorXd& start, const InnerLog& log) const;

 private:
  struct Block {  // rows of one slave body; without Dirichlet problem: diagonal
    std::vector<int> places;
    std::unique_ptr<DirichletProblem> body;
  };
  Eigen::VectorXd slave_multipliers(const Eigen::VectorXd& residual) const;
  Eigen::VectorXd precondition(Eigen::VectorXd& residual) const;

  SchwarzOptions options_;
  FrozenSet set_;
  std::vector<Block> blocks_;
  std::unique_ptr<Preconditioner> large_;  // in place of the blocks for flexibilities given as operators
  Eigen::MatrixXd carried_;                // M^-1 Q L^-T with L L^T = Q^T M^-1 Q
};

}  // namespace creepcontact::contact
