#pragma once
/// Plain Schwarz sweeps on the equations of an active set, and their acceleration.

#include "active_set.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/solver/contact_solver.hpp"
#include "dirichlet_problem.hpp"

namespace creepcontact::contact {

/// Alternating Schwarz on one active set. Made again when the set changes.
/// Even half-sweep: both traces move towards each other by the fraction a of their distance, and Dirichlet problems
/// give new multipliers; odd half-sweep: the multipliers move towards each other by the fraction b of their
/// difference, and Neumann problems give new traces. Source: Stankevich (2012), eq. 8 and 9.
/// Fractions for alpha = "diagonal", s_X = diag(F_X^-1): a_A = s_B/(s_A+s_B), b_A = s_A/(s_A+s_B) - the opposite ones;
/// with equal fractions 1/2 the sweeps diverge beyond a stiffness ratio of 3 + sqrt 8 = 5.83.
/// Bodies held by contact alone: the rigid part of the traces' distance goes into their motions, and after the odd half
/// the least multipliers that carry what is unbalanced are subtracted.
class SchwarzSweeps {
 public:
  SchwarzSweeps(const ContactProblem& problem, const SchwarzOptions& options, std::vector<int> active);
  const std::vector<int>& active() const { return set_.active(); }
  /// @param start  multipliers on the set
  InnerResult solve(const ActiveSetLoad& load, const Eigen::VectorXd& start, const InnerLog& log) const;

 private:
  struct Share {                 // one body's part
    std::vector<int> positions;  // of its rows in the active set
    Eigen::MatrixXd flexibility;
    DirichletProblem body;
    Eigen::MatrixXd rigid;      // gaps of the motions on its rows
    Eigen::VectorXd even, odd;  // fractions a and b
    Eigen::VectorXd sign;       // +1 slave, -1 master
    Index offset = 0;           // in the vector of all bodies' multipliers
    Index size() const { return sign.size(); }
  };
  void set_fractions(const std::vector<std::optional<double>>& alpha, const std::vector<std::size_t>& bodies);
  void sweep(const ActiveSetLoad& load, const Eigen::VectorXd& from, Eigen::VectorXd& to) const;
  Eigen::VectorXd mean(const Eigen::VectorXd& both) const;

  SchwarzOptions options_;
  ActiveSet set_;
  std::vector<Share> shares_;
};

}  // namespace creepcontact::contact
