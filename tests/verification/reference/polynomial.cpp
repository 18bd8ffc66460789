#include "verification/reference/polynomial.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace creepcontact::reference {

GaussRule gauss_rule(int n) {
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

LagrangeBasis::LagrangeBasis(int degree) : nodes_(degree + 1) {
  for (int i = 0; i <= degree; ++i) nodes_[i] = -std::cos(std::numbers::pi * i / degree);
}

double LagrangeBasis::value(int i, double x) const {
  double product = 1;
  for (int k = 0; k < nodes_.size(); ++k)
    if (k != i) product *= (x - nodes_[k]) / (nodes_[i] - nodes_[k]);
  return product;
}

double LagrangeBasis::slope(int i, double x) const {
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

}  // namespace creepcontact::reference
