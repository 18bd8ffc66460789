#include "least_squares.hpp"

#include <ceres/ceres.h>

#include <algorithm>

namespace creepcontact::fit {
namespace {

constexpr double difference = 5e-3;  // unknowns are of the order of one; residuals are exact to 1e-5

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

class Residuals final : public ceres::CostFunction {
 public:
  Residuals(const LeastSquares& problem, int n_residuals) : problem_(problem) {
    set_num_residuals(n_residuals);
    mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.lower.size()));
  }

  bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
    const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(parameters[0], problem_.lower.size());
    const auto values = problem_.residuals(x);
    if (!values) return false;
    std::ranges::copy(*values, residuals);
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    const auto jacobian = difference_jacobian(problem_, x);
    if (!jacobian) return false;
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::Map<RowMajor>(jacobians[0], jacobian->rows(), jacobian->cols()) = *jacobian;
    return true;
  }

 private:
  const LeastSquares& problem_;
};

}  // namespace

std::optional<Eigen::MatrixXd> difference_jacobian(const LeastSquares& problem, const Eigen::VectorXd& x) {
  Eigen::MatrixXd result;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    Eigen::VectorXd high = x, low = x;
    high[j] = std::min(x[j] + difference, problem.upper[j]);
    low[j] = std::max(x[j] - difference, problem.lower[j]);
    const auto above = problem.residuals(high), below = problem.residuals(low);
    if (!above || !below) return std::nullopt;
    if (j == 0) result.resize(static_cast<Eigen::Index>(above->size()), x.size());
    result.col(j) = (vector_of(*above) - vector_of(*below)) / (high[j] - low[j]);
  }
  return result;
}

std::optional<Minimum> minimize(const LeastSquares& problem, const Eigen::VectorXd& start, int most_iterations) {
  Minimum minimum;
  minimum.x = start.cwiseMax(problem.lower).cwiseMin(problem.upper);
  const auto first = problem.residuals(minimum.x);
  if (!first) return std::nullopt;
  {
    ceres::Problem all;
    all.AddResidualBlock(new Residuals(problem, static_cast<int>(first->size())), nullptr, minimum.x.data());
    for (Eigen::Index i = 0; i < start.size(); ++i) {
      all.SetParameterLowerBound(minimum.x.data(), static_cast<int>(i), problem.lower[i]);
      all.SetParameterUpperBound(minimum.x.data(), static_cast<int>(i), problem.upper[i]);
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.max_num_iterations = most_iterations;
    options.function_tolerance = 1e-9;
    options.parameter_tolerance = 1e-7;
    options.gradient_tolerance = 1e-12;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &all, &summary);
    minimum.converged = summary.termination_type == ceres::CONVERGENCE;
  }
  const auto residuals = problem.residuals(minimum.x);
  const auto jacobian = difference_jacobian(problem, minimum.x);
  if (!residuals || !jacobian) return std::nullopt;
  minimum.residuals = vector_of(*residuals);
  minimum.jacobian = *jacobian;
  return minimum;
}

}  // namespace creepcontact::fit
