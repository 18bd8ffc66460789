#include "least_squares.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "creepcontact/base/error.hpp"
#include "creepcontact/fit/bounded_least_squares.hpp"
#include "creepcontact/platform/companions.hpp"

namespace creepcontact::fit {
namespace {

constexpr double difference = 5e-3;  // unknowns are of the order of one; residuals are exact to 1e-5

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Minimize load_optimizer() {
  const std::filesystem::path file = platform::find_companion(optimizer_library, false);
  if (file.empty()) {
    std::string places;
    for (const std::filesystem::path& place : platform::companion_places(optimizer_library))
      places += (places.empty() ? "" : ", ") + place.string();
    throw SolverError(fmt::format("{}, which fits constants, was not found as any of {}; install creepcontact again",
                                  optimizer_library, places));
  }
  const auto reason = [] {
    const char* const text = ::dlerror();
    return text != nullptr ? text : "unknown reason";
  };
  void* const library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw SolverError(fmt::format("'{}' cannot be loaded: {}", file.string(), reason()));
  void* const function = ::dlsym(library, optimizer_function);
  if (function == nullptr)
    throw SolverError(
        fmt::format("'{}' is of another version: {}; install creepcontact again", file.string(), reason()));
  return reinterpret_cast<Minimize>(function);
}

bool evaluate(void* context, const double* at, double* residuals, double* jacobian) {
  const LeastSquares& problem = *static_cast<const LeastSquares*>(context);
  const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(at, problem.lower.size());
  const auto values = problem.residuals(x);
  if (!values) return false;
  std::ranges::copy(*values, residuals);
  if (jacobian == nullptr) return true;
  const auto derivatives = difference_jacobian(problem, x);
  if (!derivatives) return false;
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::Map<RowMajor>(jacobian, derivatives->rows(), derivatives->cols()) = *derivatives;
  return true;
}

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

std::optional<Minimum> minimize(const LeastSquares& problem, const Eigen::VectorXd& start, int max_iterations) {
  Minimum minimum;
  minimum.x = start.cwiseMax(problem.lower).cwiseMin(problem.upper);
  const auto first = problem.residuals(minimum.x);
  if (!first) return std::nullopt;
  static const Minimize minimize_bounded = load_optimizer();
  LeastSquares of = problem;
  minimum.converged = minimize_bounded({.n_unknowns = static_cast<int>(start.size()),
                                        .n_residuals = static_cast<int>(first->size()),
                                        .lower = problem.lower.data(),
                                        .upper = problem.upper.data(),
                                        .max_iterations = max_iterations,
                                        .context = &of,
                                        .evaluate = evaluate},
                                       minimum.x.data());
  const auto residuals = problem.residuals(minimum.x);
  const auto jacobian = difference_jacobian(problem, minimum.x);
  if (!residuals || !jacobian) return std::nullopt;
  minimum.residuals = vector_of(*residuals);
  minimum.jacobian = *jacobian;
  return minimum;
}

}  // namespace creepcontact::fit
