#include "batches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/base/error.hpp"

namespace creepcontact::fit {
namespace {

constexpr double far_apart = 12;        // differences of logarithms: batches are nearer
constexpr std::size_t few_batches = 5;  // whose scatter is known badly

}  // namespace

Batches::Batches(const TestData& data, const LawChoice& choice, const ParameterSpace& space)
    : data_(data), space_(space), n_(data.batches.size()) {
  if (n_ == 0) return;
  const std::size_t amplitude = space.amplitude();
  if (amplitude == space.size() || !space.is_logarithmic(amplitude))
    throw ConfigError(
        fmt::format("{}: batches differ by a factor on a constant that is a rate or a stress, and none of law '{}' is "
                    "fitted; allowed: such a constant among the fitted ones, or no column 'batch'",
                    data.file, choice.info->name));
  constant_ = static_cast<Eigen::Index>(amplitude);
}

Eigen::VectorXd Batches::extended(const Eigen::VectorXd& parameters, double sign) const {
  Eigen::VectorXd x(parameters.size() + static_cast<Eigen::Index>(n_unknowns()));
  x << parameters, Eigen::VectorXd::Constant(x.size() - parameters.size(), sign * far_apart);
  return x;
}

Eigen::VectorXd Batches::differences(const Eigen::VectorXd& x) const {
  Eigen::VectorXd all(n_);
  all << x.tail(x.size() - static_cast<Eigen::Index>(space_.size())), 0;
  all[all.size() - 1] = -all.sum();
  return all;
}

std::vector<std::shared_ptr<const material::CreepLaw>> Batches::laws(const Eigen::VectorXd& x) const {
  const auto n = static_cast<Eigen::Index>(space_.size());
  if (x.size() == n) return {space_.law(x)};
  std::vector<std::shared_ptr<const material::CreepLaw>> result;
  for (const double difference : differences(x)) {
    Eigen::VectorXd own = x.head(n);
    own[constant_] += difference;
    result.push_back(space_.law(own));
  }
  return result;
}

BatchScatter Batches::scatter(const Eigen::VectorXd& x, const Eigen::MatrixXd& covariance) const {
  const auto n = static_cast<Eigen::Index>(n_unknowns());
  const Eigen::MatrixXd own = covariance.bottomRightCorner(n, n);
  const Eigen::VectorXd found = differences(x);
  BatchScatter result{.key = space_.parameter(static_cast<std::size_t>(constant_)).key};
  double left_open = own.sum();  // of the last batch, whose difference is minus the sum of the others
  for (std::size_t b = 0; b < n_; ++b) {
    const auto i = static_cast<Eigen::Index>(b);
    const double variance = i < n ? own(i, i) : own.sum();
    if (i < n) left_open += variance;
    const auto n_tests = std::ranges::count(data_.tests, b, &Test::batch);
    result.batches.push_back({data_.batches[b], static_cast<int>(n_tests), found[i], std::sqrt(variance)});
  }
  const double variance = (found.squaredNorm() - left_open) / static_cast<double>(n);
  result.deviation = std::sqrt(std::max(0.0, variance));
  return result;
}

void warn_of_batches(FitResult& result) {
  if (!result.batches || result.batches->batches.size() >= few_batches) return;
  result.warnings.push_back(
      fmt::format("{} batches tell little of the scatter from batch to batch: a factor of {:.3g} for one standard "
                  "deviation is hardly more than a guess; take data of more batches",
                  result.batches->batches.size(), std::exp(result.batches->deviation)));
}

}  // namespace creepcontact::fit
