#pragma once
/// One body's half of the even half-sweep: the multipliers that move its trace as prescribed.

#include <Eigen/Cholesky>

#include "creepcontact/contact/solver/problem.hpp"

namespace creepcontact::contact {

/// S = F^-1 on some rows of one body. Where contact alone holds the body, the rigid part is taken out,
///   S = F^-1 - F^-1 G (G^T F^-1 G)^-1 G^T F^-1,   G: gaps of its rigid-body modes,
/// which is the same for any fixing dofs, and for F + c G G^T instead of F, which is regular.
class DirichletProblem {
 public:
  /// What is_regular() == false is for: an object that is then discarded, or the least multipliers.
  enum class IfSingular { nothing, least_multipliers };
  /// @param own  rows, as indices into the body's flexibility
  /// @param compliance  per row, of a layer on the body's surface, which is part of F
  /// Cost: a Cholesky factorisation; for least multipliers where F is singular, an eigendecomposition, which takes some
  /// hundred times as long.
  DirichletProblem(const ContactProblem& problem, std::size_t body, const std::vector<int>& own,
                   const Eigen::VectorXd& compliance, IfSingular if_singular = IfSingular::least_multipliers);

  /// False if the body's flexibility is singular on these rows: a body held there, or finer traces than it has
  /// unknowns. The multipliers are then the least ones, F^-1 a pseudo-inverse.
  bool is_regular() const { return regular_; }
  /// F^-1 trace, rigid part included.
  Eigen::VectorXd multipliers(const Eigen::VectorXd& trace) const;
  /// S trace: multipliers without resultant.
  Eigen::VectorXd balanced_multipliers(const Eigen::VectorXd& trace) const;
  /// diag S, or 1/diag F where F is singular.
  Eigen::VectorXd stiffness() const;

 private:
  Eigen::VectorXd flexibility_;  // diagonal
  Eigen::LLT<Eigen::MatrixXd> factor_;
  Eigen::MatrixXd pseudo_inverse_;  // instead of the factor where F is singular
  bool regular_ = false;
  Eigen::MatrixXd carried_;  // F^-1 B L^-T with B an orthonormal basis of G and L L^T = B^T F^-1 B: S = F^-1 - c c^T
};

/// Rows of a set that a body takes part in.
struct OwnRows {
  std::vector<int> positions;  ///< in the set
  std::vector<int> own;        ///< in the body's flexibility
};
OwnRows own_rows(const ContactProblem& problem, std::size_t body, const std::vector<int>& set);

}  // namespace creepcontact::contact
