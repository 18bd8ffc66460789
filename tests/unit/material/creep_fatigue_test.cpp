#include "creepcontact/material/creep_fatigue.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "creepcontact/base/error.hpp"
#include "creepcontact/material/registry.hpp"

namespace creepcontact::material {
namespace {

using Points = std::vector<InteractionDiagram::Point>;

TEST(FatigueCurve, OfATableIsStraightInLogarithmsAndGoesOnBeyondIt) {
  const auto curve = fatigue_table({1e-3, 1e-2, 1e-1}, {1e6, 1e3, 10});
  EXPECT_NEAR(curve->cycles(1e-3, 0), 1e6, 1e-3);
  EXPECT_NEAR(curve->cycles(1e-2, 500), 1e3, 1e-6);
  EXPECT_NEAR(curve->cycles(std::sqrt(1e-5), 0), std::sqrt(1e9), 1e-3);
  EXPECT_NEAR(curve->cycles(1e-4, 0), 1e9, 1);
  EXPECT_NEAR(curve->cycles(1, 0), 0.1, 1e-9);
}

TEST(FatigueCurve, OfAnExpressionDependsOnTheTemperature) {
  const auto curve = fatigue_expression(Function::expression("(100 - T)/eps^2", {"eps", "T"}));
  EXPECT_NEAR(curve->cycles(0.1, 20), 8000, 1e-9);
}

TEST(FatigueCurve, WhatIsNoCurveIsRefused) {
  const auto key = [](const std::vector<double>& range, const std::vector<double>& cycles) {
    try {
      fatigue_table(range, cycles);
    } catch (const ParameterError& error) {
      return error.key();
    }
    return std::string();
  };
  EXPECT_EQ(key({1e-3}, {10}), "strain_range");
  EXPECT_EQ(key({1e-3, 1e-3}, {10, 5}), "strain_range");
  EXPECT_EQ(key({0, 1e-3}, {10, 5}), "strain_range");
  EXPECT_EQ(key({1e-3, 1e-2}, {10}), "cycles");
  EXPECT_EQ(key({1e-3, 1e-2}, {10, 20}), "cycles");
  EXPECT_EQ(key({1e-3, 1e-2}, {10, 0}), "cycles");
}

TEST(InteractionDiagram, WithoutPointsAddsBothFractions) {
  EXPECT_NEAR(InteractionDiagram().usage(0.2, 0.3), 0.5, 1e-15);
  EXPECT_EQ(InteractionDiagram().usage(0, 0), 0);
}

TEST(InteractionDiagram, IsOneOnItsLineAndGrowsAlongRays) {
  const InteractionDiagram diagram(Points{{0.1, 0.5}, {0.3, 0.3}});
  for (const auto& [life, cycles] : Points{{0, 1}, {0.1, 0.5}, {0.2, 0.4}, {0.3, 0.3}, {0.65, 0.15}, {1, 0}}) {
    EXPECT_NEAR(diagram.usage(life, cycles), 1, 1e-12) << life;
    EXPECT_NEAR(diagram.usage(0.5 * life, 0.5 * cycles), 0.5, 1e-12) << life;
    EXPECT_NEAR(diagram.usage(3 * life, 3 * cycles), 3, 1e-12) << life;
  }
}

TEST(InteractionDiagram, PointsOutOfOrderAreRefused) {
  for (const Points& points : {Points{{0.3, 0.3}, {0.2, 0.2}}, Points{{0.3, 0.3}, {0.4, 0.3}}, Points{{0, 0.5}},
                               Points{{0.5, 1}}, Points{{1, 0.5}}})
    EXPECT_THROW(InteractionDiagram{points}, ParameterError);
}

/// A state of one point under a uniaxial stress of 100.
struct Point {
  Tensor6 stress = (Tensor6() << 100, 0, 0, 0, 0, 0).finished();
  std::array<double, 2> internal{};
  PointState state() const { return {.stress = tensor::view(stress), .internal = internal, .temperature = 600}; }
};

double value_of(const CreepFatigue& law, const StateVariable& variable, const Point& at) {
  std::array<double, 1> value{std::numeric_limits<double>::quiet_NaN()};
  EXPECT_TRUE(law.evaluate(variable, at.state(), value)) << variable.name;
  return value[0];
}

TEST(CreepFatigueLaw, CreepAddsByTimeAndFatigueByCycles) {
  const auto creep =
      std::make_shared<const LifeFraction>(rupture_expression(Function::expression("1e6/q", {"q", "T"})), 0.0);
  const CreepFatigue law(fatigue_table({1e-3, 1e-2}, {1e4, 1e2}), InteractionDiagram(Points{{0.3, 0.3}}), creep);
  Point at;
  Tensor6 strain = Tensor6::Zero();
  std::array<double, 2> rate{7, 7};
  law.rate(at.state(), {tensor::writable(strain), rate});
  EXPECT_NEAR(rate[0], 1e-4, 1e-12);
  EXPECT_EQ(rate[1], 0);
  EXPECT_EQ(strain, Tensor6::Zero());
  at.internal[0] = 0.15;
  for (int cycle = 0; cycle < 15; ++cycle) law.add_cycle({1e-2, 600}, at.internal);
  law.add_cycle({0, 600}, at.internal);
  EXPECT_NEAR(value_of(law, life_fraction, at), 0.15, 1e-15);
  EXPECT_NEAR(value_of(law, fatigue_fraction, at), 0.15, 1e-12);
  EXPECT_NEAR(value_of(law, creep_fatigue, at), 0.5, 1e-12);
  EXPECT_TRUE(law.counts_cycles());
}

TEST(CreepFatigueLaw, WithoutRuptureDataCountsFatigueAlone) {
  const CreepFatigue law(fatigue_table({1e-3, 1e-2}, {1e4, 1e2}), InteractionDiagram(Points{{0.3, 0.3}}), nullptr);
  Point at;
  at.internal = {0, 0.25};
  std::array<double, 1> value{};
  EXPECT_FALSE(law.evaluate(life_fraction, at.state(), value));
  EXPECT_NEAR(value_of(law, creep_fatigue, at), 0.25, 1e-12);
}

TEST(CreepFatigueLaw, ANumberOfCyclesThatIsNotPositiveIsAnError) {
  const CreepFatigue law(fatigue_expression(Function::expression("500 - T", {"eps", "T"})), {}, nullptr);
  std::array<double, 2> internal{};
  law.add_cycle({1e-2, 400}, internal);
  EXPECT_NEAR(internal[1], 0.01, 1e-15);
  EXPECT_THROW(law.add_cycle({1e-2, 600}, internal), ModelError);
}

}  // namespace
}  // namespace creepcontact::material
