#include "uncertainty.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <iterator>
#include <limits>

#include "creepcontact/base/error.hpp"
#include "creepcontact/linalg/dense.hpp"
#include "unit_expression.hpp"

namespace creepcontact::fit {
namespace {

constexpr double confidence = 0.95;
constexpr double at_bound = 1e-6;
constexpr double undetermined = 5e-4;   // ratio of singular values; derivatives are exact to that
constexpr double min_influence = 1e-9;  // of an unknown on the residuals
constexpr double wide = 10;             // ends of an interval of a parameter
constexpr double poor_fit = 0.3;
constexpr double poor_test = 1.5;  // ratio
constexpr int fewest_readings = 20;

/// Unknowns that are not at a bound.
std::vector<Eigen::Index> inner_unknowns(const LeastSquares& problem, const Eigen::VectorXd& x) {
  std::vector<Eigen::Index> inner;
  for (Eigen::Index i = 0; i < x.size(); ++i)
    if (x[i] > problem.lower[i] + at_bound && x[i] < problem.upper[i] - at_bound) inner.push_back(i);
  return inner;
}

/// Unknowns that the data do not determine.
struct Undetermined {
  std::vector<std::size_t> alone;     ///< unknowns without influence
  std::vector<std::size_t> together;  ///< unknowns of which only combinations have influence
  std::size_t n_together = 0;         ///< how many of these have to be known
};

[[noreturn]] void refuse(const TestData& data, const ParameterSpace& space, const Undetermined& unknowns) {
  const auto keys = [&](const std::vector<std::size_t>& which) {
    std::vector<std::string> names;
    names.reserve(which.size());
    for (const std::size_t i : which)
      names.push_back(i < space.size() ? space.parameter(i).key
                                       : fmt::format("batch '{}'", data.batches[i - space.size()]));
    return names;
  };
  std::vector<std::string> found;
  if (!unknowns.alone.empty())
    found.push_back(fmt::format("do not determine {}", fmt::join(keys(unknowns.alone), ", ")));
  if (!unknowns.together.empty())
    found.push_back(fmt::format("cannot tell {} apart", fmt::join(keys(unknowns.together), " and ")));
  // Held are those without unit first: their likely values are known.
  std::vector<std::size_t> held;
  std::ranges::copy_if(unknowns.together, std::back_inserter(held), [&](std::size_t i) { return i < space.size(); });
  std::stable_partition(held.begin(), held.end(), [&](std::size_t i) {
    const std::string unit = unit_in(space.parameter(i).description);
    return !unit_uses(unit, "stress") && !unit_uses(unit, "time");
  });
  held.resize(std::min(held.size(), unknowns.n_together));
  std::ranges::copy_if(unknowns.alone, std::inserter(held, held.begin()),
                       [&](std::size_t i) { return i < space.size(); });
  const DataRange range = data.range();
  std::string tested_range =
      fmt::format("stresses {:g} to {:g}, {} of them", range.stress.low, range.stress.high, data.stresses().size());
  if (data.has_temperature)
    tested_range += fmt::format("; temperatures {:g} to {:g}", range.temperature.low, range.temperature.high);
  if (range.time.high > 0) tested_range += fmt::format("; times up to {:g}", range.time.high);
  throw ConfigError(
      fmt::format("{}: the data {} ({}); hold parameters at known values, for example --set {}=..., or take a law with "
                  "fewer parameters",
                  data.file, fmt::join(found, ", and "), tested_range, fmt::join(keys(held), "=... --set ")));
}

/// Covariance of the inner unknowns for a residual deviation of 1.
Eigen::MatrixXd covariance(const TestData& data, const ParameterSpace& space, const std::vector<Eigen::Index>& inner,
                           const Eigen::MatrixXd& jacobian) {
  const auto n = static_cast<Eigen::Index>(inner.size());
  Eigen::MatrixXd columns(jacobian.rows(), n);
  Eigen::VectorXd norms(n);
  Undetermined unknowns;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index unknown = inner[static_cast<std::size_t>(i)];
    norms[i] = jacobian.col(unknown).norm();
    const bool has_influence = norms[i] > min_influence;
    if (!has_influence) unknowns.alone.push_back(static_cast<std::size_t>(unknown));
    columns.col(i) =
        has_influence ? (jacobian.col(unknown) / norms[i]).eval() : Eigen::VectorXd::Zero(jacobian.rows()).eval();
  }
  const linalg::SingularValues svd = linalg::singular_values(columns);
  const Eigen::VectorXd& values = svd.values;
  const auto n_null = static_cast<Eigen::Index>(
      std::ranges::count_if(values, [&](double value) { return value < undetermined * values[0]; }));
  if (n_null > 0) {
    unknowns.n_together = static_cast<std::size_t>(n_null) - unknowns.alone.size();
    Eigen::VectorXd shares = svd.right.rightCols(n_null).rowwise().norm();
    for (Eigen::Index i = 0; i < n; ++i)
      if (!(norms[i] > min_influence)) shares[i] = 0;
    for (Eigen::Index i = 0; i < n; ++i)
      if (unknowns.n_together > 0 && shares[i] > 0.2 * shares.maxCoeff())
        unknowns.together.push_back(static_cast<std::size_t>(inner[static_cast<std::size_t>(i)]));
    for (Eigen::Index i = 0; i < jacobian.cols(); ++i)  // at a bound, where a search without slope may have ended
      if (std::ranges::find(inner, i) == inner.end() && !(jacobian.col(i).norm() > undetermined * norms.maxCoeff()))
        unknowns.alone.push_back(static_cast<std::size_t>(i));
    std::ranges::sort(unknowns.alone);
    refuse(data, space, unknowns);
  }
  const Eigen::MatrixXd root = norms.cwiseInverse().asDiagonal() * svd.right * values.cwiseInverse().asDiagonal();
  return root * root.transpose();
}

/// Correlation of neighbouring residuals along the curves; how many times too narrow the intervals are.
void warn_of_correlation(const TestData& data, FitResult& result) {
  double products = 0, squares = 0;
  int n = 0;
  for (std::size_t t = 0; t < data.tests.size(); ++t) {
    const std::vector<double>& own = result.residuals[t];
    for (std::size_t i = 1; i < own.size(); ++i, ++n) products += own[i] * own[i - 1];
    for (const double residual : own) squares += own.size() > 1 ? residual * residual : 0;
  }
  if (n < fewest_readings || squares == 0) return;
  const double rho = std::min(products / squares, 0.99);
  if (rho < std::max(0.4, 3 / std::sqrt(n))) return;
  result.warnings.push_back(fmt::format(
      "residuals of neighbouring readings of a test are correlated ({:.2f}): not the scatter of the readings decides, "
      "but "
      "differences between specimens or between law and material; true intervals are about {:.1f} times as wide",
      rho, std::sqrt((1 + rho) / (1 - rho))));
}

void warn_of_misfit(const TestData& data, FitResult& result) {
  for (int k = 0; k < n_test_kinds; ++k) {
    const KindResiduals& kind = result.kinds[static_cast<std::size_t>(k)];
    if (kind.n > 0 && kind.deviation > poor_fit)
      result.warnings.push_back(fmt::format(
          "the law describes the readings of kind {} within a factor of {:.2f} only (root mean square of {})",
          name_of(static_cast<TestKind>(k)), std::exp(kind.deviation), kind.n));
  }
  double worst = 0;
  std::size_t number = 0;
  for (std::size_t t = 0; t < data.tests.size(); ++t) {
    double sum = 0;
    for (const double residual : result.residuals[t]) sum += residual;
    const double mean = sum / static_cast<double>(result.residuals[t].size());
    if (std::abs(mean) <= std::abs(worst)) continue;
    worst = mean;
    number = t;
  }
  if (std::exp(std::abs(worst)) > poor_test && data.tests.size() > 1)
    result.warnings.push_back(
        fmt::format("test '{}' ({}) is furthest from the law: measured are {:.2f} times its values "
                    "on average",
                    data.tests[number].name, name_of(data.tests[number].kind), std::exp(worst)));
}

void warn_of_width(const FittedParameter& parameter, bool logarithmic, FitResult& result) {
  if (parameter.at_bound)
    result.warnings.push_back(
        fmt::format("{0} is at the end of its range, {1:.4g}: the data ask for a value beyond it, or do not determine "
                    "it; hold it (--set {0}={1:.4g}), add data, or take another law",
                    parameter.key, parameter.value));
  const bool amplitude = unit_uses(parameter.unit, "stress") || unit_uses(parameter.unit, "time");
  if (!parameter.at_bound && logarithmic && !amplitude && parameter.high > wide * parameter.low)
    result.warnings.push_back(fmt::format("{} is hardly determined: its interval is {:.3g} to {:.3g}", parameter.key,
                                          parameter.low, parameter.high));
}

}  // namespace

Eigen::MatrixXd add_uncertainty(const TestData& data, const ParameterSpace& space, const LeastSquares& problem,
                                const Minimum& minimum, FitResult& result) {
  const auto n = static_cast<Eigen::Index>(space.size()), n_all = minimum.x.size();
  const std::vector<Eigen::Index> inner = inner_unknowns(problem, minimum.x);
  result.n_readings = static_cast<int>(minimum.residuals.size());
  result.degrees_of_freedom = result.n_readings - static_cast<int>(inner.size());
  result.deviation = std::sqrt(minimum.sum_of_squares() / result.degrees_of_freedom);
  result.correlation = Eigen::MatrixXd::Constant(n, n, std::numeric_limits<double>::quiet_NaN());
  Eigen::MatrixXd of_unknowns = Eigen::MatrixXd::Zero(n_all, n_all);
  if (!inner.empty()) {
    const Eigen::MatrixXd own = covariance(data, space, inner, minimum.jacobian);
    for (std::size_t i = 0; i < inner.size(); ++i)
      for (std::size_t j = 0; j < inner.size(); ++j)
        of_unknowns(inner[i], inner[j]) = own(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }
  of_unknowns *= result.deviation * result.deviation;
  const Eigen::VectorXd x = minimum.x.head(n);
  const Eigen::MatrixXd slopes = space.slopes(x);
  const Eigen::MatrixXd covariances = slopes * of_unknowns.topLeftCorner(n, n) * slopes.transpose();
  const boost::math::students_t distribution(result.degrees_of_freedom);
  const double factor = boost::math::quantile(distribution, 0.5 * (1 + confidence));
  const Eigen::VectorXd values = space.values(x);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double half = factor * std::sqrt(covariances(i, i));
    FittedParameter parameter{.key = space.parameter(k).key,
                              .unit = unit_in(space.parameter(k).description),
                              .value = values[i],
                              .low = space.is_logarithmic(k) ? values[i] * std::exp(-half) : values[i] - half,
                              .high = space.is_logarithmic(k) ? values[i] * std::exp(half) : values[i] + half,
                              .at_bound = std::ranges::find(inner, i) == inner.end(),
                              .is_logarithmic = space.is_logarithmic(k),
                              .deviation = std::sqrt(covariances(i, i))};
    warn_of_width(parameter, space.is_logarithmic(k), result);
    result.parameters.push_back(std::move(parameter));
    for (Eigen::Index j = 0; j < n; ++j)
      if (covariances(i, i) > 0 && covariances(j, j) > 0)
        result.correlation(i, j) = covariances(i, j) / std::sqrt(covariances(i, i) * covariances(j, j));
  }
  warn_of_misfit(data, result);
  warn_of_correlation(data, result);
  return of_unknowns;
}

}  // namespace creepcontact::fit
