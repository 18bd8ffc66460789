#pragma once
/// The two ways through F_II lambda = -gap that know the bodies apart: plain Schwarz sweeps, and conjugate gradients
/// preconditioned by the slave's half of a sweep.

#include "creepcontact/contact/contact_solver.hpp"

namespace creepcontact::contact {

/// Outcome on a frozen set; `multiplier` is indexed like the set.
struct SweepResult {
  Eigen::VectorXd multiplier;
  int iterations = 0;
  bool converged = false;
};

/// Alternating Schwarz on one active set. Made anew when the set changes.
/// Even half-sweep: both traces move towards each other by the fraction a of their distance, and Dirichlet problems
/// give new multipliers; odd half-sweep: the multipliers move towards each other by the fraction b of their
/// difference, and Neumann problems give new traces. Source: Stankevich (2012), eq. 8 and 9.
/// Fractions for alpha = "diagonal", s_X = diag(F_X^-1): a_A = s_B/(s_A+s_B), b_A = s_A/(s_A+s_B) - the opposite ones;
/// with equal fractions 1/2 the sweeps diverge beyond a stiffness ratio of 3 + sqrt 8 = 5.83.
class SchwarzSweeps {
 public:
  SchwarzSweeps(const ContactProblem& problem, const SchwarzOptions& options, std::vector<int> active);
  const std::vector<int>& active() const { return active_; }
  /// @param gap  on the set; @param start  multipliers on the set
  SweepResult solve(const Eigen::VectorXd& gap, const Eigen::VectorXd& start) const;

 private:
  struct Share {              // one body's part
    std::vector<int> places;  // of its rows in the active set
    Eigen::MatrixXd flexibility;
    Eigen::LLT<Eigen::MatrixXd> factor;
    Eigen::VectorXd even, odd;  // fractions a and b
    Eigen::VectorXd sign;       // +1 slave, -1 master
    Eigen::Index offset = 0;    // in the vector of all bodies' multipliers
  };
  void sweep(const Eigen::VectorXd& gap, const Eigen::VectorXd& from, Eigen::VectorXd& to) const;
  Eigen::VectorXd mean(const Eigen::VectorXd& both) const;

  SchwarzOptions options_;
  std::vector<int> active_;
  Eigen::MatrixXd total_;
  std::vector<Share> shares_;
};

/// Conjugate gradients on the same equations.
class SchwarzGradients {
 public:
  SchwarzGradients(const ContactProblem& problem, const SchwarzOptions& options, std::vector<int> active);
  const std::vector<int>& active() const { return active_; }
  SweepResult solve(const Eigen::VectorXd& gap, const Eigen::VectorXd& start) const;

 private:
  struct Block {  // rows of one slave body; empty factor: diagonal
    std::vector<int> places;
    Eigen::LLT<Eigen::MatrixXd> factor;
    Eigen::VectorXd inverse_diagonal;
  };
  Eigen::VectorXd precondition(const Eigen::VectorXd& residual) const;

  SchwarzOptions options_;
  std::vector<int> active_;
  Eigen::MatrixXd total_;
  std::vector<Block> blocks_;
};

}  // namespace creepcontact::contact
