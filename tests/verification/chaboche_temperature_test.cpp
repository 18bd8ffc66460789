// The law chaboche at a temperature that runs through 960 degrees in each cycle, against published figures.

#include "verification/cube.hpp"

namespace creepcontact {
namespace chaboche_temperature_tests {
namespace {

using namespace test;

// Test HSNV125 D of code_aster (astest/hsnv125d.comm, law VISCOCHAB): tension by hindered thermal strain
// with a constant shear. Its reference is PHI2AS (G. Cailletaud), whose figures it takes with the tolerances below;
// the others are what code_aster computes itself.
const char* const hsnv125 = R"toml(
  [mesh]
  file = "case.geo"
  order = 1
  [bodies.cube]
  region = "cube"
  material = "alloy"
  [materials.alloy]
  young_modulus = "2e5 - 1e5*((T - 100)/960)^2"
  poisson_ratio = 0.3
  thermal_expansion = "1e-5 + 1e-5*((T - 100)/960)^4"
  reference_temperature = 20
  [[materials.alloy.creep]]
  law = "chaboche"
  yield = 200
  Q = -100
  b = 20
  K = "300 - 300*((T - 700)/700)^2"
  n = "7 - (T - 100)/160"
  C = ["1e6 - 98500*(T - 100)/96"]
  gamma = ["5000 - 5*(T - 100)"]
  [[loads]]
  on = "x0"
  traction = [0, "-100*min(t, 1)", 0]
  [[loads]]
  on = "x1"
  traction = [0, "100*min(t, 1)", 0]
  [temperature]
  value = { t = [0, 1, 61, 121, 181, 241, 301, 361, 421, 481], values = [1060, 1060, 100, 1060, 100, 1060, 100, 1060, 100, 1060] }
  [time]
  end = 481
  output = [421, 449.8, 465.4, 473.8]
  [[probes]]
  name = "sxx"
  quantity = "stress_xx"
  body = "cube"
  [[probes]]
  name = "exy"
  quantity = "strain_xy"
  body = "cube"
)toml";
const char* const stretch =
    "{ t = [0, 1, 61, 121, 181, 241, 301, 361, 421, 481], values = [2.08, 2.08, 0.08, 2.08, 0.08, 2.08, 0.08, 2.08, "
    "0.08, 2.08] }";

struct Published {
  double time, stress, stress_tolerance, stress_of_aster, shear, shear_tolerance, shear_of_aster;
};
constexpr Published published[] = {{421, -337.04, 0.01, -335.323, 0.014608, 0.06, 0.015435},
                                   {449.8, 320.54, 0.01, 318.044, 0.015251, 0.06, 0.016111},
                                   {465.4, 211.13, 0.03, 209.349, 0.015917, 0.06, 0.016779},
                                   {473.8, -31.97, 0.10, -28.813, 0.016086, 0.06, 0.017021},
                                   {481, -89.79, 0.20, -72.132, 0.019981, 0.08, 0.021385}};

class ChabocheTemperature : public testing::TestWithParam<const char*> {};

TEST_P(ChabocheTemperature, FollowsHsnv125OfCodeAster) {
  const std::string supports =
      support("x0", "x") + support("x1", "x", stretch) + support("z0", "z") + support("corner", "y");
  const Outcome outcome = run_case(hsnv125 + supports, std::string(cube_geo) + "Physical Point(\"corner\") = {1};\n",
                                   {std::string("time.integrator=") + GetParam()});
  for (const Published& row : published) {
    const double stress = outcome.history.at("sxx", row.time), shear = outcome.history.at("exy", row.time);
    EXPECT_NEAR(stress, row.stress_of_aster, 1e-3 * 337) << row.time;
    EXPECT_RELATIVE(shear, row.shear_of_aster, 1e-2);
    EXPECT_RELATIVE(stress, row.stress, row.stress_tolerance);
    EXPECT_RELATIVE(shear, row.shear, row.shear_tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(Integrators, ChabocheTemperature, testing::Values("auto", "log_adams", "cvode_bdf"),
                         [](const auto& integrator) { return std::string(integrator.param); });

}  // namespace
}  // namespace chaboche_temperature_tests
}  // namespace creepcontact
