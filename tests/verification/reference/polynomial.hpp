#pragma once
/// Gauss rules and Lagrange polynomials of any degree on [-1, 1], for the radial elements of the reference solutions.

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <utility>

namespace creepcontact::reference {

struct GaussRule {
  Eigen::VectorXd points, weights;
};

/// Gauss-Legendre with n points: zeros of P_n by Newton's method.
inline GaussRule gauss_rule(int n) {
  GaussRule rule{Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (int i = 0; i < n; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), slope = 0;
    for (int iteration = 0; iteration < 20; ++iteration) {
      double p = x, before = 1;
      for (int k = 2; k <= n; ++k) before = std::exchange(p, ((2 * k - 1) * x * p - (k - 1) * before) / k);
      slope = n * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    rule.points[i] = x;
    rule.weights[i] = 2 / ((1 - x * x) * slope * slope);
  }
  return rule;
}

/// Lagrange polynomials through the Chebyshev-Lobatto nodes, which include both ends.
class LagrangeBasis {
 public:
  explicit LagrangeBasis(int degree) : nodes_(degree + 1) {
    for (int i = 0; i <= degree; ++i) nodes_[i] = -std::cos(std::numbers::pi * i / degree);
  }
  double node(int i) const { return nodes_[i]; }

  double value(int i, double x) const {
    double product = 1;
    for (int k = 0; k < nodes_.size(); ++k)
      if (k != i) product *= (x - nodes_[k]) / (nodes_[i] - nodes_[k]);
    return product;
  }

  double slope(int i, double x) const {
    double sum = 0;
    for (int j = 0; j < nodes_.size(); ++j) {
      if (j == i) continue;
      double product = 1 / (nodes_[i] - nodes_[j]);
      for (int k = 0; k < nodes_.size(); ++k)
        if (k != i && k != j) product *= (x - nodes_[k]) / (nodes_[i] - nodes_[k]);
      sum += product;
    }
    return sum;
  }

 private:
  Eigen::VectorXd nodes_;
};

}  // namespace creepcontact::reference
