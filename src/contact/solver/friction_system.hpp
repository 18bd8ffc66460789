#pragma once
/// The linear equations of contact with friction near a state: which equation each row fulfils, and their solution.

#include <array>
#include <functional>
#include <list>
#include <memory>
#include <vector>

#include "creepcontact/base/stop_request.hpp"
#include "creepcontact/contact/solver/problem.hpp"

namespace creepcontact::contact {

/// A vector turned by 90 degrees.
inline Eigen::Vector2d turned(const Eigen::Vector2d& direction) {
  return {-direction.y(), direction.x()};
}

/// One per node of the problem.
using Linearization = std::vector<NodeLinearization>;

/// Rows and flexibilities of a problem, as the equations of friction need them. Soft springs hold bodies that are held
/// by contact alone; what they carry must be iterated to zero (method of multipliers).
class FrictionRows {
 public:
  FrictionRows() = default;
  /// @param problem  must outlive the object
  explicit FrictionRows(const ContactProblem& problem);

  const ContactProblem& problem() const { return *problem_; }
  bool is_movable(int row) const { return movable_[row] != 0; }
  /// Gap that a unit multiplier opens at its own row; positive.
  double flexibility(int row) const { return flexibility_[row]; }
  /// Tangential rows of a node along which it can move, at most two.
  struct Tangents {
    int n = 0;
    std::array<int, 2> rows{};
    std::array<int, 2> components{};  ///< of the vectors of NodeLinearization
    double flexibility = 0;           ///< mean

    /// The tangential part of a vector over all rows; zero along what is held.
    Eigen::Vector2d of(const Eigen::VectorXd& all) const {
      Eigen::Vector2d part = Eigen::Vector2d::Zero();
      for (int k = 0; k < n; ++k) part[components[k]] = all[rows[k]];
      return part;
    }
  };
  const Tangents& tangents(std::size_t node) const { return tangents_[node]; }
  /// What motions open in the equations of a state, n_rows x n_motions.
  Eigen::MatrixXd motions(const Linearization& at) const;
  /// Stiffness of the springs on the rigid-body modes; 0 without any.
  double spring() const { return spring_; }
  /// 1 / the largest eigenvalue of the tangential part of F, scaled to a unit diagonal: steps of the tractions against
  /// the slip, in units of 1/diag F, that are no longer than this move no node too far. Cost: some products with F.
  double tangential_step() const;
  /// F multiplier + N N^T multiplier / spring
  Eigen::VectorXd gaps(const Eigen::VectorXd& multiplier) const;
  /// N N^T multiplier / spring
  Eigen::VectorXd spring_gaps(const Eigen::VectorXd& multiplier) const;

  /// Left-hand sides of all rows for multipliers and their gaps.
  /// @param bound  per node: limit of the shear traction in addition to mu lambda_n; empty: none
  Eigen::VectorXd equations(const Linearization& at, const Eigen::VectorXd& multiplier, const Eigen::VectorXd& gap,
                            const Eigen::VectorXd& bound = {}) const;

 private:
  const ContactProblem* problem_ = nullptr;
  Eigen::VectorXd flexibility_;
  std::vector<char> movable_;
  std::vector<Tangents> tangents_;
  double spring_ = 0;
};

/// Solver of these equations. What it returns depends on its arguments only.
class FrictionSystem {
 public:
  /// @param problem  must outlive the object
  explicit FrictionSystem(const ContactProblem& problem);
  ~FrictionSystem();
  const FrictionRows& rows() const { return rows_; }
  /// Must be called when the flexibilities of the problem have changed.
  void flexibility_changed();
  /// Sets the request that all later iterations heed: the solutions then throw Cancelled.
  void set_stop(const StopRequest& stop) { stop_ = stop; }

  struct Solution {
    Eigen::VectorXd multiplier;
    Eigen::VectorXd rigid;  ///< amplitudes of the rigid-body modes; empty if springs hold the bodies
    int iterations = 0;     ///< 0: by a factor of these very equations
  };
  /// Multipliers whose left-hand sides are `right`, where springs hold all bodies.
  /// @param factored  equations whose factor is the preconditioner of GMRES; empty: the equations themselves are
  /// factored, unless the flexibility is an operator
  /// @param tolerance  relative, of the residual
  /// Cost: products with F and triangular solves per iteration; one LU factorisation of the rows in contact when
  /// `factored` changes, or if many iterations do not suffice.
  Solution solve_held(const Linearization& at, const Linearization& factored, const Eigen::VectorXd& right,
                      double tolerance);
  /// Solution without springs: multipliers and amplitudes whose left-hand sides are `right`, with N^T multiplier =
  /// `resultant`. Amplitudes of motions that the rows in contact do not hold are zero.
  Solution solve(const Linearization& at, const Linearization& factored, const Eigen::VectorXd& right,
                 const Eigen::VectorXd& resultant, double tolerance);

 private:
  class Factor;
  const Factor& factor(const Linearization& at);
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> approximate_inverse(const Linearization& at) const;

  const ContactProblem& problem_;
  FrictionRows rows_;
  StopRequest stop_;
  std::list<std::unique_ptr<const Factor>> factors_;  // the last used first
};

}  // namespace creepcontact::contact
