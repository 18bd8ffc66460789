/// Known parameters are found again from data with scatter, within their confidence intervals.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "creepcontact/fit/fit.hpp"
#include "synthetic.hpp"

namespace creepcontact::fit {
namespace {

constexpr double scatter = 0.05;

/// A law, its true parameters and the tests made of it.
struct Case {
  std::string law;
  std::vector<double> truth;  ///< the required keys
  std::vector<SyntheticTest> tests;
  LawWishes wishes = {};
  std::vector<std::pair<std::string, double>> optional = {};  ///< fitted besides
};

FitResult fitted(const Case& one, int seed, double noise) {
  material::ParameterValues values;
  for (const double value : one.truth) values.push_back({value});
  const auto& keys = material::find_creep_law(one.law)->parameters;
  for (const auto& [key, value] : one.optional)
    for (std::size_t i = values.size(); i < keys.size(); ++i)
      values.push_back({keys[i].key == key ? Function(value) : keys[i].fallback->front()});
  const TestData data = synthetic(law_of(one.law, values), one.tests, noise, seed);
  LawWishes wishes = one.wishes;
  wishes.law = one.law;
  return fit_law(data, choose_law(wishes, data), Function(1.5e5));
}

std::vector<double> truths(const Case& one) {
  std::vector<double> all = one.truth;
  for (const auto& [key, value] : one.optional) all.push_back(value);
  return all;
}

/// Of the intervals of all parameters in many random sets, 95 % should hold the truth; of each alone, 90 % at least.
void expect_coverage(const Case& one, int n_sets = 200) {
  const std::vector<double> truth = truths(one);
  std::vector<int> inside(truth.size(), 0);
  double variance = 0;  // of the residuals, relative to that of the noise
  for (int seed = 0; seed < n_sets; ++seed) {
    const FitResult result = fitted(one, seed, scatter);
    ASSERT_EQ(result.parameters.size(), truth.size());
    for (std::size_t i = 0; i < truth.size(); ++i)
      inside[i] += result.parameters[i].low <= truth[i] && truth[i] <= result.parameters[i].high;
    variance += std::pow(result.deviation / scatter, 2) / n_sets;
  }
  EXPECT_NEAR(variance, 1, 0.15);  // below 1, for small readings near the floor of a test count for less
  int all = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_GE(inside[i], 0.9 * n_sets - (n_sets < 200 ? 3 : 0)) << "parameter " << i;
    if (n_sets >= 200) {
      EXPECT_LE(inside[i], 0.995 * n_sets) << "parameter " << i << ": intervals are too wide";
    }
    all += inside[i];
  }
  EXPECT_NEAR(all / (n_sets * static_cast<double>(truth.size())), 0.95, n_sets < 200 ? 0.06 : 0.03);
}

std::vector<SyntheticTest> creep_at(const std::vector<double>& stresses, const std::vector<double>& times) {
  std::vector<SyntheticTest> tests;
  for (const double stress : stresses) tests.push_back({TestKind::creep, stress, 20, times});
  return tests;
}

Case norton() {
  return {"norton", {3e-17, 5.5}, creep_at({80, 110, 150, 200}, log_times(10, 3000, 8))};
}
Case hardening() {
  return {"strain_hardening", {2e-10, 3.2, 0.35}, creep_at({80, 120, 170}, log_times(1, 5000, 10))};
}
Case rabotnov() {
  Case one{"kachanov_rabotnov", {2e-17, 5, 4e-15, 4.5, 6}, {}};
  for (const double stress : {90.0, 120.0, 150.0, 200.0}) {
    const double rupture = 1 / (7 * 4e-15 * std::pow(stress, 4.5));
    one.tests.push_back({TestKind::creep, stress, 20, log_times(0.05 * rupture, 0.97 * rupture, 12)});
    one.tests.push_back({TestKind::rupture, stress, 20});
  }
  return one;
}
Case arrhenius() {
  Case one{"norton", {2e5, 4.5}, {}, {}, {{"activation_energy", 3e5}}};
  for (const double T : {500.0, 550.0, 600.0})
    for (const double stress : {100.0, 200.0})
      one.tests.push_back({TestKind::creep, stress, T, log_times(10, 3000, 6)});
  return one;
}

TEST(Recovery, ExactDataGiveTheExactParameters) {
  for (const Case& one : {norton(), hardening(), rabotnov(), arrhenius()}) {
    const FitResult result = fitted(one, 0, 0);
    const std::vector<double> truth = truths(one);
    for (std::size_t i = 0; i < truth.size(); ++i)
      EXPECT_NEAR(std::log(result.parameters[i].value / truth[i]), 0, 2e-3)
          << one.law << ' ' << result.parameters[i].key;
  }
}

/// Creep curves of batches, each with a factor of its own on A.
TestData of_batches(int n, double deviation, int seed) {
  TestData all;
  for (int b = 0; b < n; ++b) {
    const double factor = std::exp(deviation * Noise(1000 * seed + b)());
    TestData one = synthetic(law_of("norton", {{3e-17 * factor}, {5.5}}),
                             creep_at({80, 110, 150}, log_times(10, 3000, 5)), scatter, 100 * seed + b);
    if (b == 0) all = one;
    all.batches.push_back(std::string(1, static_cast<char>('a' + b)));
    if (b > 0) std::ranges::copy(one.tests, std::back_inserter(all.tests));
    for (std::size_t t = all.tests.size() - one.tests.size(); t < all.tests.size(); ++t)
      all.tests[t].batch = static_cast<std::size_t>(b);
  }
  return all;
}

TEST(Batches, AreToldApartFromReadings) {
  LawWishes wishes;
  wishes.law = "norton";
  constexpr double deviation = 0.7;
  constexpr int n_sets = 40, n_batches = 8;
  double variance = 0, readings = 0;
  int inside = 0;
  for (int seed = 0; seed < n_sets; ++seed) {
    const TestData data = of_batches(n_batches, deviation, seed);
    const FitResult result = fit_law(data, choose_law(wishes, data), std::nullopt);
    ASSERT_TRUE(result.batches);
    EXPECT_EQ(result.batches->key, "A");
    ASSERT_EQ(result.batches->batches.size(), 8u);
    double sum = 0, mean = 0, largest = 0;
    for (int b = 0; b < n_batches; ++b) mean += deviation * Noise(1000 * seed + b)() / n_batches;
    for (int b = 0; b < n_batches; ++b) {
      const BatchScatter::Batch& batch = result.batches->batches[static_cast<std::size_t>(b)];
      EXPECT_EQ(batch.n_tests, 3);
      sum += batch.difference;
      largest = std::max(largest, std::abs(batch.difference - (deviation * Noise(1000 * seed + b)() - mean)));
    }
    EXPECT_NEAR(sum, 0, 1e-9);
    EXPECT_LT(largest, 4 * result.batches->batches.back().deviation);
    variance += std::pow(result.batches->deviation, 2) / n_sets;
    readings += std::pow(result.deviation, 2) / n_sets;
    inside += result.parameters[1].low <= 5.5 && 5.5 <= result.parameters[1].high ? 1 : 0;
  }
  EXPECT_NEAR(std::sqrt(variance), deviation, 0.06);  // of 40 sets: 0.7/sqrt(2 x 7 x 40)
  EXPECT_NEAR(std::sqrt(readings), scatter, 0.003);
  EXPECT_GE(inside, 34);
}

TEST(Batches, ThatDoNotDifferHaveNoScatter) {
  LawWishes wishes;
  wishes.law = "norton";
  const TestData data = of_batches(6, 0, 3);
  const FitResult result = fit_law(data, choose_law(wishes, data), std::nullopt);
  EXPECT_LT(result.batches.value().deviation, 0.03);
  EXPECT_TRUE(result.warnings.empty());
  const FitResult few = fit_law(of_batches(2, 0.5, 1), choose_law(wishes, data), std::nullopt);
  EXPECT_EQ(few.warnings.size(), 1u);
}

TEST(Recovery, Norton) {
  expect_coverage(norton());
}
TEST(Recovery, NortonWithActivationEnergy) {
  expect_coverage(arrhenius());
}
TEST(Recovery, StrainHardening) {
  expect_coverage(hardening());
}

}  // namespace
}  // namespace creepcontact::fit
