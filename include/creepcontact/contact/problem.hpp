#pragma once
/// The contact problem in multiplier space, condensed from all bodies:
///   gap = initial gap + sum_b F_b lambda,   lambda >= 0, gap >= 0, lambda . gap = 0   (tied rows: gap = 0)
/// F_b is body b's flexibility on the rows it takes part in: the gaps that unit multipliers open by moving this body.

#include <Eigen/Dense>
#include <vector>

namespace creepcontact::contact {

struct Flexibility {
  std::vector<int> rows;   ///< ascending
  Eigen::MatrixXd matrix;  ///< rows.size() square, symmetric positive semidefinite
};

struct ContactProblem {
  std::vector<Flexibility> bodies;
  std::vector<int> slave_body, master_body;  ///< of each row
  std::vector<char> bilateral;               ///< of each row: tied
  Eigen::MatrixXd total;                     ///< sum of the bodies' flexibilities

  int n_rows() const { return static_cast<int>(total.rows()); }
};

/// Multipliers and the rows that are in contact (ascending). Both empty: nothing known yet.
struct ContactState {
  Eigen::VectorXd multiplier;
  std::vector<int> active;
};

struct ContactResult {
  ContactState state;
  int iterations = 0;   ///< Schwarz sweeps or conjugate-gradient iterations; 0 for the active-set method
  int set_changes = 0;  ///< updates of the active set
};

/// The set that the multipliers and gaps of a solution on some set ask for: rows with lambda_i - gap_i/F_ii > 0, and
/// all tied ones. Changes below 1e-12 of the largest multiplier count as none.
std::vector<int> updated_set(const ContactProblem& problem, const std::vector<int>& current,
                             const Eigen::VectorXd& multiplier, const Eigen::VectorXd& gap);

/// Where to begin: the warm start's set, or the rows that overlap without contact.
std::vector<int> first_set(const ContactProblem& problem, const Eigen::VectorXd& initial_gap, const ContactState& warm);

}  // namespace creepcontact::contact
