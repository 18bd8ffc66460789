#pragma once
/// Nonlinear least squares with bounds.

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

namespace creepcontact::fit {

/// Minimise the sum of squares of r(x), lower <= x <= upper.
struct LeastSquares {
  /// nullopt where r is not defined: such steps are shortened
  std::function<std::optional<std::vector<double>>(const Eigen::VectorXd&)> residuals;
  Eigen::VectorXd lower, upper;
};

struct Minimum {
  Eigen::VectorXd x, residuals;
  Eigen::MatrixXd jacobian;  ///< dr/dx at x
  bool converged = false;
  double sum_of_squares() const { return residuals.squaredNorm(); }
};

/// Derivatives by differences, within the bounds. @returns nullopt where r is not defined
/// Cost: two evaluations of r per unknown.
std::optional<Eigen::MatrixXd> difference_jacobian(const LeastSquares& problem, const Eigen::VectorXd& x);

/// A local minimum near `start`: Levenberg-Marquardt with a projection onto the bounds.
/// @param max_iterations  > 0 @returns nullopt if r is not defined at the start
std::optional<Minimum> minimize(const LeastSquares& problem, const Eigen::VectorXd& start, int max_iterations);

}  // namespace creepcontact::fit
