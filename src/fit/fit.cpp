#include "creepcontact/fit/fit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "batches.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "law_response.hpp"
#include "least_squares.hpp"
#include "parameter_space.hpp"
#include "starts.hpp"
#include "uncertainty.hpp"
#include "unit_expression.hpp"

namespace creepcontact::fit {
namespace {

constexpr int max_starts = 8;
constexpr int max_iterations = 60;
constexpr int enough_agreeing = 2;
constexpr double same_minimum = 1e-3;  // of the sum of squares
constexpr int weighted_rounds = 3;
constexpr int many_readings = 20000;  // too many for all searches
constexpr int likely_iterations = 6;  // near the minimum, with what follows it
constexpr int fewest_to_weight = 4;   // readings of a kind whose scatter is estimated

/// Data with about `n` of the readings: evenly chosen ones of each test, or of the tests if there are more tests than
/// n.
TestData thinned(const TestData& data, int n) {
  TestData some = data;
  const auto wanted = static_cast<std::size_t>(n);
  if (some.tests.size() > wanted) {
    const std::size_t stride = some.tests.size() / wanted + 1;
    std::vector<Test> kept;
    for (std::size_t i = 0; i < some.tests.size(); i += stride) kept.push_back(std::move(some.tests[i]));
    some.tests = std::move(kept);
  }
  const std::size_t stride = static_cast<std::size_t>(some.n_readings()) / wanted + 1;
  for (Test& test : some.tests) {
    std::vector<Reading> kept;
    const std::size_t last = test.readings.size() - 1;
    for (std::size_t i = 0; i < last; i += stride) kept.push_back(test.readings[i]);
    kept.push_back(test.readings[last]);
    test.readings = std::move(kept);
  }
  return some;
}

/// A fit while it is made.
class Search {
 public:
  Search(const TestData& data, const LawChoice& choice, const std::optional<Function>& young_modulus)
      : data_(data),
        choice_(choice),
        young_modulus_(young_modulus),
        space_(choice, data),
        batches_(data, choice, space_),
        response_(data, young_modulus) {
    for (const Test& test : data.tests) kinds_.insert(kinds_.end(), test.readings.size(), test.kind);
    weights_.fill(1);
    problem_ = {[this](const Eigen::VectorXd& x) { return weighted(x); }, batches_.extended(space_.lower(), -1),
                batches_.extended(space_.upper(), 1)};
  }

  FitResult run() {
    const std::size_t n_unknowns = space_.size() + batches_.n_unknowns();
    if (data_.n_readings() <= static_cast<int>(n_unknowns))
      throw ConfigError(fmt::format("{}: {} readings for {} parameters{}; allowed: more readings than parameters",
                                    data_.file, data_.n_readings(), n_unknowns,
                                    batches_.n_unknowns() > 0 ? ", those of the batches included" : ""));
    FitResult result;
    Minimum minimum = with_batches(first_minimum(result));
    result.law = space_.law(minimum.x.head(static_cast<Eigen::Index>(space_.size())));
    if (const std::string reason = response_.why_impossible(result.law); !reason.empty())
      throw ConfigError(fmt::format("{}: law '{}': {}", data_.file, choice_.info->name, reason));
    for (int round = 0; round < weighted_rounds && weigh(minimum); ++round)
      if (auto again = minimize(problem_, minimum.x, max_iterations)) minimum = std::move(*again);
    describe(minimum, result);
    return result;
  }

 private:
  std::optional<std::vector<double>> weighted(const Eigen::VectorXd& x) const {
    std::optional<std::vector<double>> residuals;
    try {
      residuals = response_.residuals(batches_.laws(x));
    } catch (const material::ParameterError&) {
      return std::nullopt;  // within their ranges, but not possible together
    }
    if (!residuals) return residuals;
    for (std::size_t i = 0; i < residuals->size(); ++i)
      (*residuals)[i] *= weights_[static_cast<std::size_t>(kinds_[i])];
    return residuals;
  }

  /// A strain of the order of the measured ones.
  double typical_strain() const {
    double largest = 0;
    for (const Test& test : data_.tests)
      if (test.kind == TestKind::creep) largest = std::max(largest, test.readings.back().value);
    return largest > 0 ? largest : 0.01;
  }

  /// If there are many readings, some of them suffice to find the neighbourhood of the minimum; all of them then refine
  /// it.
  Minimum first_minimum(FitResult& result) const {
    const LeastSquares all{problem_.residuals, space_.lower(), space_.upper()};  // as if of one batch
    if (data_.n_readings() <= many_readings) return best_minimum(all, result);
    const TestData some = thinned(data_, many_readings / 4);
    log::info("fit: {} readings; the search for the minimum begins with {} of them", data_.n_readings(),
              some.n_readings());
    const LawResponse of_some(some, young_modulus_);
    const LeastSquares problem{[&](const Eigen::VectorXd& x) -> std::optional<std::vector<double>> {
                                 try {
                                   return of_some.residuals(std::vector{space_.law(x)});
                                 } catch (const material::ParameterError&) {
                                   return std::nullopt;
                                 }
                               },
                               all.lower, all.upper};
    const Minimum near = best_minimum(problem, result);
    const auto begin = std::chrono::steady_clock::now();
    static_cast<void>(all.residuals(near.x));
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const double evaluations = likely_iterations * (2.0 * static_cast<double>(space_.size()) + 1);
    log::info("fit: {} searches have ended; the last one takes all readings, some {:.0f} s ({:.0f} x {:.2f} s)",
              result.n_starts, evaluations * seconds, evaluations, seconds);
    if (auto found = minimize(all, near.x, max_iterations)) return std::move(*found);
    log::info("fit: the law is not defined there for all readings; the search begins again with all of them");
    result.n_starts = result.n_agreeing = 0;
    return best_minimum(all, result);
  }

  /// The minimum with the differences of the batches as unknowns.
  Minimum with_batches(Minimum minimum) const {
    if (batches_.n_unknowns() == 0) return minimum;
    if (auto found = minimize(problem_, batches_.extended(minimum.x, 0), max_iterations)) return std::move(*found);
    throw SolverError(fmt::format("{}: the law is not defined for the batches apart", data_.file));
  }

  Minimum best_minimum(const LeastSquares& problem, FitResult& result) const {
    std::optional<Minimum> best;
    const auto starts = best_starts(problem, max_starts, space_.lowest_guess(typical_strain()), space_.highest_guess(),
                                    space_.amplitude());
    for (const Eigen::VectorXd& start : starts) {
      auto found = minimize(problem, start, max_iterations);
      if (!found) continue;
      ++result.n_starts;
      const double old = best ? best->sum_of_squares() : std::numeric_limits<double>::infinity();
      const double now = found->sum_of_squares();
      if (std::abs(now - old) <= same_minimum * old + 1e-20)
        ++result.n_agreeing;
      else if (now < old)
        result.n_agreeing = 1;
      if (now < old) best = std::move(found);
      if (result.n_agreeing >= enough_agreeing) break;
    }
    if (!best) {
      (void)space_.law(0.5 * (space_.lowest_guess(typical_strain()) + space_.highest_guess()));  // throws if impossible
      throw SolverError(fmt::format("{}: {}", data_.file, why_no_start()));
    }
    return std::move(*best);
  }

  std::string why_no_start() const {
    std::vector<std::string> held;
    for (const auto& [key, value] : choice_.set) held.push_back(fmt::format("{} = {}", key, value));
    const Interval stress = data_.range().stress;
    return fmt::format("the law '{}' gives no finite values at stresses {:g} to {:g}{}{}{}", choice_.info->name,
                       stress.low, stress.high, held.empty() ? "" : " with ", fmt::join(held, ", "),
                       held.empty() ? " at any of the starting points; hold parameters at likely values (--set)"
                                    : ", whatever the other parameters are; check these values and their units");
  }

  /// Kinds of readings that scatter differently count by their scatter. @returns false if there is one kind alone
  bool weigh(const Minimum& minimum) {
    const double dof = static_cast<double>(kinds_.size() - static_cast<std::size_t>(minimum.x.size())) /
                       static_cast<double>(kinds_.size());
    std::array<double, n_test_kinds> sums{}, numbers{};
    double pooled = 0;
    for (std::size_t i = 0; i < kinds_.size(); ++i) {
      const auto k = static_cast<std::size_t>(kinds_[i]);
      const double residual = minimum.residuals[static_cast<Eigen::Index>(i)] / weights_[k];
      sums[k] += residual * residual;
      pooled += residual * residual;
      ++numbers[k];
    }
    pooled = std::sqrt(pooled / (dof * static_cast<double>(kinds_.size())));
    if (std::ranges::count_if(numbers, [](double n) { return n > 0; }) < 2 || !(pooled > 0)) return false;
    for (std::size_t k = 0; k < weights_.size(); ++k) {
      const bool known = numbers[k] >= fewest_to_weight;
      const double own = known ? std::max(std::sqrt(sums[k] / (dof * numbers[k])), 0.1 * pooled) : pooled;
      weights_[k] = pooled / own;
    }
    return true;
  }

  void describe(const Minimum& minimum, FitResult& result) {
    result.law = space_.law(minimum.x.head(static_cast<Eigen::Index>(space_.size())));
    const auto residuals = response_.residuals(batches_.laws(minimum.x));
    std::size_t next = 0;
    for (const Test& test : data_.tests) {
      KindResiduals& kind = result.kinds[static_cast<std::size_t>(test.kind)];
      result.residuals.emplace_back();
      for (std::size_t i = 0; i < test.readings.size(); ++i, ++next, ++kind.n) {
        result.residuals.back().push_back((*residuals)[next]);
        kind.deviation += (*residuals)[next] * (*residuals)[next];
      }
    }
    for (KindResiduals& kind : result.kinds)
      if (kind.n > 0) kind.deviation = std::sqrt(kind.deviation / kind.n);
    result.range = data_.range();
    const Eigen::MatrixXd covariance = add_uncertainty(data_, space_, problem_, minimum, result);
    if (batches_.n_unknowns() > 0) result.batches = batches_.scatter(minimum.x, covariance);
    warn_of_batches(result);
  }

  const TestData& data_;
  const LawChoice& choice_;
  const std::optional<Function>& young_modulus_;
  ParameterSpace space_;
  Batches batches_;
  LawResponse response_;
  std::vector<TestKind> kinds_;  // per residual
  std::array<double, n_test_kinds> weights_;
  LeastSquares problem_;
};

}  // namespace

FitResult fit_law(const TestData& data, const LawChoice& choice, const std::optional<Function>& young_modulus) {
  try {
    return Search(data, choice, young_modulus).run();
  } catch (const material::ParameterError& error) {
    throw ConfigError(fmt::format("law '{}': {}", choice.info->name, error.what()));
  }
}

}  // namespace creepcontact::fit
