#pragma once
/// Conjugate gradients on the equations of an active set, preconditioned by the softer body's half of a sweep.

#include <memory>

#include "active_set.hpp"
#include "creepcontact/contact/solver/contact_solver.hpp"
#include "dirichlet_problem.hpp"

namespace creepcontact::contact {

/// F_II lambda + N_I alpha = -gap and N_I^T lambda = -resultant. All iterates balance the resultants: the iteration
/// starts from multipliers that do, and the preconditioner is that of Gould, Hribar and Nocedal (2001),
///   z = M^-1 r - M^-1 Q (Q^T M^-1 Q)^-1 Q^T M^-1 r,   M: F_softer, Q: orthonormal basis of N_I,
/// for a floating body its Dirichlet half-sweep without rigid part. alpha follows from the residual left. The softer
/// body of two is the slave, unless the master is clearly softer and fine enough for its flexibility to be regular.
class ProjectedCg {
 public:
  ProjectedCg(const ContactProblem& problem, const SchwarzOptions& options, std::vector<int> active);
  const std::vector<int>& active() const { return set_.active(); }
  const RigidBalance& balance() const { return set_.balance(); }
  /// @param start  multipliers on the set
  InnerResult solve(const ActiveSetLoad& load, const Eigen::VectorXd& start, const InnerLog& log) const;

 private:
  struct Block {  // rows of one body
    std::vector<int> positions;
    std::unique_ptr<DirichletProblem> body;
  };
  /// Adds a block of the places and takes them away, if the body's flexibility is regular there.
  bool add_block(const ContactProblem& problem, std::size_t body, std::vector<int>& positions);
  /// Sum of diag F of the body.
  double flexibility_on(const ContactProblem& problem, std::size_t body, const std::vector<int>& positions) const;
  void add_blocks(const ContactProblem& problem);
  Eigen::VectorXd softer_multipliers(const Eigen::VectorXd& residual) const;
  Eigen::VectorXd precondition(Eigen::VectorXd& residual) const;

  SchwarzOptions options_;
  ActiveSet set_;
  std::vector<Block> blocks_;
  std::vector<int> loose_;                 // places without block: diagonal
  std::unique_ptr<Preconditioner> large_;  // instead of the blocks for flexibilities given as operators
  Eigen::MatrixXd carried_;                // M^-1 Q L^-T with L L^T = Q^T M^-1 Q
};

}  // namespace creepcontact::contact
