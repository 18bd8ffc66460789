#include "verification/reference/hot_cylinder.hpp"

#include <gtest/gtest.h>

#include "verification/reference/thick_cylinder.hpp"

namespace creepcontact::reference {
namespace {

/// Timoshenko and Goodier, Theory of Elasticity, article 151: steady heat flow through the wall.
TEST(HotCylinder, ThermalStressesOfALogarithmicTemperature) {
  const double a = 100, b = 200, E = 2e5, nu = 0.3, alpha = 1.2e-5, Ti = 100;
  const HotCylinderHistory history({a, b, 0, E, nu, 1, [](double) { return 0.0; },
                                    [=](double r) { return alpha * Ti * std::log(b / r) / std::log(b / a); }},
                                   4, 8);
  const auto stress = history.stress({0})[0];
  const double scale = E * alpha * Ti / (2 * (1 - nu) * std::log(b / a)), k = a * a / (b * b - a * a) * std::log(b / a);
  for (std::size_t p = 0; p < stress.size(); ++p) {
    const double r = history.radii()[p], log = std::log(b / r), square = b * b / (r * r);
    EXPECT_NEAR(stress[p][0], scale * (-log - k * (1 - square)), 1e-6 * scale);
    EXPECT_NEAR(stress[p][1], scale * (1 - log - k * (1 + square)), 1e-6 * scale);
  }
}

TEST(HotCylinder, PressureAloneGivesLameAndThenTheSteadyState) {
  const ThickCylinder exact{100, 200, 200};
  const HotCylinderHistory history(
      {100, 200, 200, 2e5, 0.3, 5, [](double) { return 3.125e-14; }, [](double) { return 1e-3; }}, 4, 8);
  const auto stress = history.stress({200})[0];
  for (std::size_t p = 0; p < stress.size(); ++p) {
    const double r = history.radii()[p];
    EXPECT_NEAR(stress[p][0], exact.steady_sigma_r(r, 5), 1e-4 * 200);
    EXPECT_NEAR(stress[p][1], exact.steady_sigma_theta(r, 5), 1e-4 * 200);
    EXPECT_NEAR(stress[p][2], exact.steady_sigma_z(r, 5), 1e-4 * 200);
  }
}

}  // namespace
}  // namespace creepcontact::reference
