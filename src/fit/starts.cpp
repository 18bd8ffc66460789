#include "starts.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

namespace creepcontact::fit {
namespace {

constexpr int n_candidates = 40;

/// A number in [0, 1), the same on all platforms.
double uniform(std::mt19937_64& generator) {
  return static_cast<double>(generator() >> 11U) * 0x1p-53;
}

std::vector<int> permutation(int n, std::mt19937_64& generator) {
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  for (int i = n - 1; i > 0; --i) std::swap(order[i], order[static_cast<int>(uniform(generator) * (i + 1))]);
  return order;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double sum_of_squares(const std::vector<double>& values) {
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

}  // namespace

std::vector<Eigen::VectorXd> latin_hypercube(int n, const Eigen::VectorXd& low, const Eigen::VectorXd& high) {
  std::mt19937_64 generator(1);
  std::vector<Eigen::VectorXd> points(n, low);
  for (Eigen::Index j = 0; j < low.size(); ++j) {
    const std::vector<int> order = permutation(n, generator);
    for (int i = 0; i < n; ++i)
      points[i][j] = low[j] + (high[j] - low[j]) * (order[i] + uniform(generator)) / static_cast<double>(n);
  }
  return points;
}

std::vector<Eigen::VectorXd> best_starts(const LeastSquares& problem, int n, const Eigen::VectorXd& low,
                                         const Eigen::VectorXd& high, std::size_t amplitude) {
  std::vector<std::pair<double, Eigen::VectorXd>> rated;
  for (Eigen::VectorXd& point : latin_hypercube(n_candidates, low, high)) {
    auto residuals = problem.residuals(point);
    for (int round = 0; residuals && round < 2 && amplitude < static_cast<std::size_t>(low.size()); ++round) {
      Eigen::VectorXd shifted = point;
      const auto a = static_cast<Eigen::Index>(amplitude);
      shifted[a] = std::clamp(point[a] + mean(*residuals), problem.lower[a], problem.upper[a]);
      const auto better = problem.residuals(shifted);
      if (!better || sum_of_squares(*better) >= sum_of_squares(*residuals)) break;
      point = shifted;
      residuals = better;
    }
    if (residuals) rated.emplace_back(sum_of_squares(*residuals), std::move(point));
  }
  std::ranges::stable_sort(rated, {}, [](const auto& one) { return one.first; });
  std::vector<Eigen::VectorXd> best;
  for (std::size_t i = 0; i < rated.size() && i < static_cast<std::size_t>(n); ++i)
    best.push_back(std::move(rated[i].second));
  return best;
}

}  // namespace creepcontact::fit
