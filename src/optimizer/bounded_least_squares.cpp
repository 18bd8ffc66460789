#include "creepcontact/fit/bounded_least_squares.hpp"

#include <ceres/ceres.h>

namespace creepcontact::fit {
namespace {

class Residuals final : public ceres::CostFunction {
 public:
  explicit Residuals(const BoundedLeastSquares& problem) : problem_(problem) {
    set_num_residuals(problem.n_residuals);
    mutable_parameter_block_sizes()->push_back(problem.n_unknowns);
  }

  bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
    return problem_.evaluate(problem_.context, parameters[0], residuals, jacobians != nullptr ? jacobians[0] : nullptr);
  }

 private:
  const BoundedLeastSquares& problem_;
};

}  // namespace
}  // namespace creepcontact::fit

extern "C" [[gnu::visibility("default")]] bool creepcontact_minimize(
    const creepcontact::fit::BoundedLeastSquares& problem, double* x) {
  ceres::Problem all;
  all.AddResidualBlock(new creepcontact::fit::Residuals(problem), nullptr, x);
  for (int i = 0; i < problem.n_unknowns; ++i) {
    all.SetParameterLowerBound(x, i, problem.lower[i]);
    all.SetParameterUpperBound(x, i, problem.upper[i]);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = problem.max_iterations;
  options.function_tolerance = 1e-9;
  options.parameter_tolerance = 1e-7;
  options.gradient_tolerance = 1e-12;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &all, &summary);
  return summary.termination_type == ceres::CONVERGENCE;
}
