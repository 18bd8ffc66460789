#include "creepcontact/contact/gasket_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <stdexcept>

#include "creepcontact/contact/gasket.hpp"
#include "support/says.hpp"

namespace creepcontact::contact {
namespace {

using creepcontact::test::message_of;
using creepcontact::test::says;

const GasketCurve loading{{0, 0.1, 0.25, 0.5, 0.8, 1.2}, {0, 4, 15, 40, 75, 140}};
// Slopes 200 + 400 m MPa/mm at a thickness of 4.5 mm.
const GasketUnloading unloading{{15, 40, 75}, {1350, 1800, 2340}, {}};

GasketLaw graphite() {
  return {4.5, {{0, loading, unloading}}};
}

TEST(GasketLaw, UnloadsAlongLinesFromTheLargestClosure) {
  const GasketLaw law = graphite();
  constexpr double largest = 0.5857142857142857;  // at 50 MPa
  const ClosureCurve curve = law.curve(largest, 0);
  EXPECT_NEAR(curve.pressure(largest), 50, 1e-12);
  EXPECT_NEAR(curve.line(largest).slope, 434.2857142857143, 1e-9);
  EXPECT_NEAR(curve.begin(), 0.4705827, 1e-7);
  EXPECT_NEAR(curve.pressure(0.5), 50 - 434.2857142857143 * (largest - 0.5), 1e-9);
  EXPECT_NEAR(curve.pressure(0.8), 75, 1e-12) << "beyond the largest closure it loads";
  EXPECT_NEAR(curve.pressure(1.3), 140 + 0.1 * 65 / 0.4, 1e-9);
}

TEST(GasketLaw, IsTheLoadingCurveAtFirst) {
  const ClosureCurve curve = graphite().curve(0, 0);
  for (std::size_t i = 0; i < loading.closure.size(); ++i)
    EXPECT_NEAR(curve.pressure(loading.closure[i]), loading.pressure[i], 1e-12);
}

TEST(GasketLaw, InterpolatesBetweenUnloadingCurvesThatNeverCross) {
  GasketUnloading curves;
  curves.curves = {{{0.1, 0.2, 0.25}, {0, 5, 15}}, {{0.5, 0.6, 0.75, 0.8}, {0, 10, 45, 75}}};
  const GasketLaw law(4.5, {{0, loading, curves}});
  const ClosureCurve first = law.curve(0.25, 0), second = law.curve(0.8, 0);
  EXPECT_NEAR(first.pressure(0.2), 5, 1e-12);
  EXPECT_NEAR(second.pressure(0.75), 45, 1e-12);
  double before = 0;
  for (double largest = 0.3; largest < 0.8; largest += 0.05) {
    const ClosureCurve between = law.curve(largest, 0);
    EXPECT_NEAR(between.pressure(largest), law.curve(0, 0).pressure(largest), 1e-9);
    EXPECT_GT(between.begin(), before) << "residual closures grow with the largest one";
    before = between.begin();
  }
}

TEST(GasketLaw, IsLinearInTheTemperature) {
  GasketCurve hot = loading;
  for (double& pressure : hot.pressure) pressure *= 0.5;
  const GasketLaw law(4.5, {{20, loading, unloading}, {420, hot, unloading}});
  EXPECT_NEAR(law.curve(0, 20).pressure(0.4), law.curve(0, -100).pressure(0.4), 1e-12);
  EXPECT_NEAR(law.curve(0, 220).pressure(0.4), 0.75 * law.curve(0, 20).pressure(0.4), 1e-12);
  EXPECT_NEAR(law.curve(0.6, 220).pressure(0.6), 0.75 * law.curve(0, 20).pressure(0.6), 1e-12);
}

TEST(GasketLaw, NamesThePointsThatAreNotPossible) {
  const auto message = [](const GasketCurve& curve, const GasketUnloading& back = {}) {
    return message_of<std::invalid_argument>([&] { GasketLaw(4.5, {{0, curve, back}}); });
  };
  EXPECT_TRUE(says(message({{0, 0.1, 0.2}, {0, 4, 4}}), {"pressure", "point 2 is 4 and point 3 is 4"}));
  EXPECT_TRUE(says(message({{0, 0.1, 0.1}, {0, 4, 5}}), {"closure", "point 2"}));
  EXPECT_TRUE(says(message({{0, 0.1}, {1, 4}}), {"first pressure must be 0"}));
  EXPECT_TRUE(says(message({{0, 0.1}, {0, 4, 5}}), {"2 closures", "3 pressures"}));
  EXPECT_TRUE(says(message(loading, {{15, 40}, {1350}, {}}), {"2 pressures", "1 moduli"}));
  EXPECT_TRUE(says(message(loading, {{15}, {100}, {}}), {"steeper than loading"}));
  EXPECT_TRUE(says(message(loading, {{}, {}, {{{0.1, 0.25}, {0, 20}}}}), {"curve 1", "15", "0.25", "20"}));
}

// c(t) = sin(t) at t = 1.2, 1.5, 1.8: the largest is 1 at pi/2, and the last one is below 0.98.
TEST(GasketHistory, FindsAMaximumBetweenSteps) {
  GasketHistory history;
  history.largest.setZero(1);
  for (const double t : {1.2, 1.5, 1.8}) history.advance(t, Eigen::VectorXd::Constant(1, std::sin(t)));
  EXPECT_NEAR(history.largest[0], 1, 1e-3);
  EXPECT_GT(history.largest[0], std::sin(1.5) + 1e-3);
}

// The estimate is of the size of the error, also where the steps are uneven; nothing else has one.
TEST(GasketHistory, EstimatesTheErrorOfAMaximum) {
  const auto passed = [](std::initializer_list<double> times) {
    GasketHistory history;
    history.largest.setZero(1);
    for (const double t : times) history.advance(t, Eigen::VectorXd::Constant(1, std::exp(t / 2) * std::sin(t)));
    return history;
  };
  const double at = std::numbers::pi - std::atan(2.0), exact = std::exp(at / 2) * std::sin(at);
  for (const auto& times :
       {std::initializer_list<double>{1.2, 1.7, 2.2, 2.7}, {1.6, 1.9, 2.2, 2.5, 2.8}, {1.5, 1.9, 2.4, 2.6}}) {
    const GasketHistory history = passed(times);
    const double error = std::abs(history.largest[0] - exact);
    EXPECT_GT(history.error[0], 0.3 * error);
    EXPECT_LT(history.error[0], 10 * error);
  }
  EXPECT_EQ(passed({0.3, 0.6, 0.9, 1.2}).error[0], 0);
}

}  // namespace
}  // namespace creepcontact::contact
