#pragma once
/// The contact problem in multiplier space, condensed from all bodies. With the multipliers lambda (contact pressures)
/// and the amplitudes alpha of the rigid motions that contact alone holds:
///   gap = initial gap + sum_b F_b lambda + N alpha,   N^T lambda + resultant = 0,
///   lambda >= 0, gap >= 0, lambda . gap = 0   (tied rows: gap = 0)
/// F_b is body b's flexibility on the rows it takes part in: the gaps that unit multipliers open by straining this
/// body. A body held by contact alone is strained about some statically determinate pins: F_b depends on their choice,
/// the solution does not, since N^T lambda + resultant = 0 leaves the pins without force. Source: Farhat and Roux
/// (1991), rigid motions of floating subdomains in dual form.

#include <Eigen/Core>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/solver/flexibility_operator.hpp"

namespace creepcontact::contact {

struct Flexibility {
  std::vector<int> rows;   ///< ascending
  Eigen::MatrixXd matrix;  ///< rows.size() square, symmetric positive semidefinite
};

struct ContactProblem {
  std::vector<Flexibility> bodies;
  std::vector<int> slave_body, master_body;  ///< of each row
  std::vector<char> bilateral;               ///< of each row: tied
  Eigen::MatrixXd total;                     ///< sum of the bodies' flexibilities; empty if ...
  const FlexibilityOperator* large =
      nullptr;  ///< ... it is given as an operator, together with `bodies` without matrices
  /// N, n_rows x n_motions (no columns if supports hold all bodies): the gaps that unit amplitudes open, summed over
  /// the bodies. A motion may move several bodies.
  Eigen::MatrixXd rigid;
  /// The same, body by body (rows of the body x n_motions): the part that this body's movement opens.
  std::vector<Eigen::MatrixXd> rigid_of_body;

  Index n_rows() const { return std::ssize(slave_body); }
  Index n_motions() const { return rigid.cols(); }
};

/// What the loads ask of contact.
struct ContactLoad {
  Eigen::VectorXd gap;        ///< weighted gaps without contact forces, n_rows
  Eigen::VectorXd resultant;  ///< work of the loads on unit rigid motions, n_motions; empty: none
};

/// Multipliers, amplitudes of the rigid motions and the rows that are in contact (ascending). All empty: nothing known.
struct ContactState {
  Eigen::VectorXd multiplier;
  Eigen::VectorXd rigid;
  std::vector<int> active;
};

struct ContactResult {
  ContactState state;
  Eigen::VectorXd gap;  ///< weighted gaps of all rows in this state
  int iterations = 0;   ///< Schwarz sweeps or conjugate-gradient iterations; 0 for the active-set method
  int set_changes = 0;  ///< updates of the active set
};

/// Thrown when no contact pressures can balance the loads: the bodies fly off along `motion` (amplitudes of the rigid
/// motions). It opens all contacts or leaves them as they are, and the loads do work along it.
struct UnbalancedLoad {
  Eigen::VectorXd motion;
};

/// gap = load.gap + F lambda + N alpha
Eigen::VectorXd contact_gaps(const ContactProblem& problem, const ContactLoad& load, const ContactState& state);

/// F lambda
Eigen::VectorXd flexibility_product(const ContactProblem& problem, const Eigen::VectorXd& multiplier);
/// diag F, or an estimate of it.
Eigen::VectorXd flexibility_diagonal(const ContactProblem& problem);

/// Gap that a unit multiplier opens at its own row, the measure of gaps against multipliers. At the pins of a body held
/// by contact alone F_ii may vanish: its rigid motions put a floor under it.
Eigen::VectorXd row_flexibility(const ContactProblem& problem);

/// Rows that no body can move along (supports hold both sides), ascending: they carry no multiplier, whatever their
/// gap.
std::vector<int> immovable_rows(const ContactProblem& problem);

/// Flexibility that makes F + c N N^T regular at the pins without a new scale: trace F / |N|^2; 0 without motions.
double pin_flexibility(const ContactProblem& problem);

/// What rounding makes of multipliers that are zero, as those of a body that moves out of an overlap unhindered: 1e-13
/// of the ones that the gaps without contact forces ask for.
double multiplier_rounding(const ContactProblem& problem, const ContactLoad& load);

/// The set that the multipliers and gaps of a solution on some set ask for: rows with lambda_i - gap_i/F_ii > 0, and
/// all tied ones. Changes below 1e-12 of the largest multiplier, or below the rounding, count as none.
std::vector<int> updated_set(const ContactProblem& problem, const std::vector<int>& current,
                             const Eigen::VectorXd& multiplier, const Eigen::VectorXd& gap, double rounding);

/// Where to begin: the warm start's set, or the rows that overlap without contact.
std::vector<int> first_set(const ContactProblem& problem, const Eigen::VectorXd& initial_gap, const ContactState& warm);

}  // namespace creepcontact::contact
