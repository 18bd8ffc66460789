#pragma once
/// Gauss rules and Lagrange polynomials of any degree on [-1, 1], for the radial elements of the reference solutions.

#include <Eigen/Core>

namespace creepcontact::reference {

struct GaussRule {
  Eigen::VectorXd points, weights;
};

/// Gauss-Legendre with n points: zeros of P_n by Newton's method.
GaussRule gauss_rule(int n);

/// Lagrange polynomials through the Chebyshev-Lobatto nodes, which include both ends.
class LagrangeBasis {
 public:
  explicit LagrangeBasis(int degree);
  double node(int i) const { return nodes_[i]; }

  double value(int i, double x) const;

  double slope(int i, double x) const;

 private:
  Eigen::VectorXd nodes_;
};

}  // namespace creepcontact::reference
