/// A rate that code evaluates at many points at once is the law of the same expression.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "creepcontact/material/registry.hpp"

namespace creepcontact::material {
namespace {

/// 1e-12 q^3/eps, with or without derivatives of its own.
class Rate final : public BatchedFunction {
 public:
  explicit Rate(bool knows_derivatives) : knows_derivatives_(knows_derivatives) {}
  void evaluate(std::span<const Arguments> at, std::span<double> values) const override {
    ++calls;
    for (std::size_t p = 0; p < at.size(); ++p) values[p] = 1e-12 * std::pow(at[p].q, 3) / at[p].eps;
  }
  bool differentiate(std::span<const Arguments> at, std::span<double> by_stress,
                     std::span<double> by_strain) const override {
    for (std::size_t p = 0; knows_derivatives_ && p < at.size(); ++p) {
      by_stress[p] = 3e-12 * std::pow(at[p].q, 2) / at[p].eps;
      by_strain[p] = -1e-12 * std::pow(at[p].q, 3) / std::pow(at[p].eps, 2);
    }
    return knows_derivatives_;
  }
  mutable int calls = 0;

 private:
  bool knows_derivatives_;
};

TEST(BatchedRate, AllPointsAtOnceAndEachAlone) {
  const auto law_of = [](Function rate) {
    return find_creep_law("expression")->make_by_key({{"rate", {std::move(rate)}}});
  };
  const auto expression = law_of(Function::expression("1e-12*q^3/eps", {"q", "eps"}));
  EXPECT_EQ(expression->n_prepared(), 0U);
  constexpr std::size_t n = 5;
  std::vector<Tensor6> stress(n);
  std::vector<double> strain(n);
  std::vector<PointState> points;
  points.reserve(n);
  for (std::size_t p = 0; p < n; ++p) {
    stress[p] << 100.0 + 20.0 * static_cast<double>(p), 5, -7, 3, 1, 2;
    strain[p] = 1e-3 * static_cast<double>(p + 1);
    points.push_back({.stress = tensor::view(stress[p]), .internal = {&strain[p], 1}});
  }
  const Tensor6 change = Tensor6::LinSpaced(1, 6);
  const double strain_change = 1e-4;
  const auto results = [&](const CreepLaw& law, const PointState& at) {
    std::vector<double> all;
    double internal = 0;
    Tensor6 rate = Tensor6::Zero(), derivative = Tensor6::Zero();
    law.rate(at, {tensor::writable(rate), {&internal, 1}});
    all.push_back(internal);
    law.derivative(at, {.stress = tensor::view(change), .internal = {&strain_change, 1}},
                   {tensor::writable(derivative), {&internal, 1}});
    all.push_back(internal);
    const StressTangent tangent = law.stress_tangent(at);
    all.insert(all.end(), {tangent.deviatoric, tangent.radial});
    all.insert(all.end(), rate.data(), rate.data() + 6);
    all.insert(all.end(), derivative.data(), derivative.data() + 6);
    return all;
  };
  for (const bool knows_derivatives : {false, true}) {
    const auto rate = std::make_shared<Rate>(knows_derivatives);
    const auto law = law_of(Function::batched("of code", {"q", "eps"}, rate));
    EXPECT_EQ(law->n_internal(), 1);
    const std::vector<double> prepared = law->prepare(points, true);
    EXPECT_EQ(rate->calls, knows_derivatives ? 1 : 5);
    ASSERT_EQ(prepared.size(), n * law->n_prepared());
    const int calls = rate->calls;
    for (std::size_t p = 0; p < n; ++p) {
      PointState at = points[p];
      at.prepared = std::span(prepared).subspan(p * law->n_prepared(), law->n_prepared());
      const std::vector<double> found = results(*law, at);
      EXPECT_EQ(rate->calls, calls);
      const std::vector<double> expected = results(*expression, points[p]), alone = results(*law, points[p]);
      for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(found[i], expected[i], 1e-8 * std::abs(expected[i])) << p << ' ' << i;
        EXPECT_NEAR(alone[i], expected[i], 1e-8 * std::abs(expected[i])) << p << ' ' << i;
      }
      rate->calls = calls;
    }
    EXPECT_EQ(law->prepare(points, false)[0], prepared[0]);
  }
}

}  // namespace
}  // namespace creepcontact::material
