/// Gauss-Legendre rules and their tensor products.
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "creepcontact/base/index.hpp"
#include "creepcontact/fem/quadrature.hpp"

namespace creepcontact::fem {

QuadratureRule gauss_line(int n) {
  if (n < 1 || n > 5) throw std::invalid_argument("Gauss rule with " + std::to_string(n) + " points; allowed: 1 to 5");
  QuadratureRule rule{Eigen::MatrixX3d::Zero(n, 3), Eigen::VectorXd(n)};
  for (int i = 0; i < n; ++i) {
    // Newton's method for the roots of the Legendre polynomial; from this start it converges in at most five steps.
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    double derivative = 1;
    for (int iteration = 0; iteration < 10; ++iteration) {
      double p = 1, previous = 0;
      for (int k = 1; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * p - (k - 1) * previous) / k;
        previous = p;
        p = next;
      }
      derivative = n * (x * p - previous) / (x * x - 1);
      x -= p / derivative;
    }
    rule.points(i, 0) = x;
    rule.weights[i] = 2 / ((1 - x * x) * derivative * derivative);
  }
  if (n % 2 == 1) rule.points(n / 2, 0) = 0;
  return rule;
}

QuadratureRule gauss_quadrilateral(int n) {
  const QuadratureRule line = gauss_line(n);
  const Index size = Index{n} * n;
  QuadratureRule rule{Eigen::MatrixX3d::Zero(size, 3), Eigen::VectorXd(size)};
  for (int j = 0, point = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i, ++point) {
      rule.points.row(point) << line.points(i, 0), line.points(j, 0), 0;
      rule.weights[point] = line.weights[i] * line.weights[j];
    }
  }
  return rule;
}

namespace {

/// Product of a plane rule with Gauss-Legendre in the third direction; the plane rule runs fastest.
QuadratureRule extrude(const QuadratureRule& plane, int n_line) {
  const QuadratureRule line = gauss_line(n_line);
  const Index n = plane.size();
  QuadratureRule rule{Eigen::MatrixX3d(n * n_line, 3), Eigen::VectorXd(n * n_line)};
  for (int k = 0; k < n_line; ++k) {
    rule.points.middleRows(k * n, n) = plane.points;
    rule.points.block(k * n, 2, n, 1).setConstant(line.points(k, 0));
    rule.weights.segment(k * n, n) = line.weights[k] * plane.weights;
  }
  return rule;
}

}  // namespace

QuadratureRule gauss_hexahedron(int n) {
  return extrude(gauss_quadrilateral(n), n);
}

QuadratureRule wedge(int triangle_degree, int n_line) {
  return extrude(triangle(triangle_degree), n_line);
}

}  // namespace creepcontact::fem
