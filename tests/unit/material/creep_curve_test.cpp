/// Creep curves against closed forms.

#include "creepcontact/material/creep_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "creepcontact/material/registry.hpp"
#include "unit/material/with_defaults.hpp"

namespace creepcontact::material {
namespace {

Material of(const std::string& law, ParameterValues values) {
  Material material;
  material.name = "m";
  const auto& keys = find_creep_law(law)->parameters;
  for (std::size_t i = values.size(); i < keys.size(); ++i) values.push_back(keys[i].fallback.value());
  material.creep.push_back(make_law(law, std::move(values)));
  return material;
}

/// @param exact  creep strain at a time
template <typename Exact>
void expect_curve(const CreepCurve& curve, double tolerance, const Exact& exact) {
  ASSERT_GT(curve.time.size(), 100U);
  for (std::size_t i = 0; i < curve.time.size(); ++i)
    EXPECT_NEAR(curve.strain[i] / exact(curve.time[i]), 1, tolerance) << "t = " << curve.time[i];
}

TEST(CreepCurve, NortonGrowsInProportionToTime) {
  const CreepCurve curve = creep_curve(of("norton", {{1e-12}, {3.0}}), {.stress = 100, .end = 1e5});
  EXPECT_NEAR(curve.time.back(), 1e5, 1e-6);
  EXPECT_NEAR(curve.time.front(), 0.1, 1e-9);
  expect_curve(curve, 1e-9, [](double t) { return 1e-6 * t; });
}

TEST(CreepCurve, HardeningLawsFollowTheirPowerOfTime) {
  for (const char* law : {"time_hardening", "strain_hardening", "ageing"})
    expect_curve(creep_curve(of(law, {{1e-9}, {2.0}, {0.4}}), {.stress = 100, .end = 1e4}), 1e-3,
                 [](double t) { return 1e-5 * std::pow(t, 0.4); });
}

TEST(CreepCurve, RetardationOfAKelvinElementSaturates) {
  expect_curve(creep_curve(of("hereditary", {{2e-5}, {10.0}}), {.stress = 100, .end = 1e4}), 2e-3,
               [](double t) { return -2e-3 * std::expm1(-t / 10); });
}

TEST(CreepCurve, DamageEndsAtRupture) {
  // w' = B q^r / (1 + phi) / (1 - w)^phi as Kachanov: rupture when its integral is 1.
  const CreepCurve curve =
      creep_curve(of("kachanov_rabotnov", {{1e-12}, {3.0}, {1e-9}, {3.0}, {4.0}}), {.stress = 100, .end = 1e6});
  ASSERT_FALSE(curve.time.empty());
  EXPECT_LT(curve.time.back(), 1e6);
  for (std::size_t i = 1; i < curve.time.size(); ++i) EXPECT_GE(curve.strain[i], curve.strain[i - 1]);
}

TEST(CreepCurve, AnElasticMaterialHasNone) {
  EXPECT_TRUE(creep_curve(Material(), {.stress = 100, .end = 1}).time.empty());
}

}  // namespace
}  // namespace creepcontact::material
