/// NAFEMS R0027 (Becker & Hyde), secondary creep: uniform states of a cube, on several kinds of elements.

#include "verification/case.hpp"
#include "verification/reference/relaxation.hpp"

namespace creepcontact {
namespace {

using test::Outcome;

/// A cube of 100 mm; hexahedra, wedges or tetrahedra.
std::string cube(const std::string& kind) {
  std::string geo = R"(
    Point(1) = {0, 0, 0}; Point(2) = {100, 0, 0}; Point(3) = {100, 100, 0}; Point(4) = {0, 100, 0};
    Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
    Line Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
    Transfinite Curve{1, 2, 3, 4} = 3; Transfinite Surface{1};)";
  if (kind == "hex") geo += "Recombine Surface{1};";
  geo += "out[] = Extrude {0, 0, 100} { Surface{1};";
  if (kind != "tet") geo += " Layers{1}; Recombine;";
  geo += R"( };
    Physical Volume("cube") = {out[1]};
    Physical Surface("z0") = {1}; Physical Surface("z1") = {out[0]};
    Physical Surface("y0") = {out[2]}; Physical Surface("x1") = {out[3]};
    Physical Surface("y1") = {out[4]}; Physical Surface("x0") = {out[5]};
  )";
  return geo;
}

/// @param conditions  supports and loads besides the symmetry planes x = 0, y = 0, z = 0
std::string configuration(const std::string& conditions, const std::string& outputs) {
  return R"(
    [mesh]
    file = "case.geo"
    [bodies.cube]
    region = "cube"
    material = "steel"
    [materials.steel]
    young_modulus = 200e3
    poisson_ratio = 0.3
    [[materials.steel.creep]]
    law = "norton"
    A = 3.125e-14
    n = 5.0
    [time]
    end = 1000
    tolerance = 1e-6
    output = )" +
         outputs + R"(
    [[supports]]
    on = "x0"
    displacement = { x = 0 }
    [[supports]]
    on = "y0"
    displacement = { y = 0 }
    [[supports]]
    on = "z0"
    displacement = { z = 0 }
    [[probes]]
    name = "sxx"
    quantity = "stress_xx"
    body = "cube"
    [[probes]]
    name = "sxx_max"
    quantity = "stress_xx"
    body = "cube"
    reduce = "max"
    [[probes]]
    name = "szz"
    quantity = "stress_zz"
    body = "cube"
    [[probes]]
    name = "cxx"
    quantity = "creep_strain_xx"
    body = "cube"
    [[probes]]
    name = "cyy"
    quantity = "creep_strain_yy"
    at = [30, 30, 30]
    [[probes]]
    name = "czz"
    quantity = "creep_strain_zz"
    body = "cube"
    )" + conditions;
}

class UniformStates : public testing::TestWithParam<std::pair<std::string, int>> {
 protected:
  Outcome run(const std::string& conditions, const std::string& outputs) const {
    return test::run_case(configuration(conditions, outputs), cube(GetParam().first),
                          {"mesh.order=" + std::to_string(GetParam().second)});
  }
};

const char* const decades = "[0.1, 1, 5, 10, 50, 100, 500, 1000]";
const std::vector<double> decade_times{0.1, 1, 5, 10, 50, 100, 500, 1000};

TEST_P(UniformStates, UniaxialTension) {
  const Outcome outcome = run(R"(
    [[loads]]
    on = "x1"
    pressure = -200
    )",
                              "[1, 10, 1000]");
  for (const double t : {1.0, 10.0, 1000.0}) {
    EXPECT_RELATIVE(outcome.history.at("cxx", t), 0.01 * t, 1e-6);
    EXPECT_RELATIVE(outcome.history.at("cyy", t), -0.005 * t, 1e-6);
    EXPECT_RELATIVE(outcome.history.at("czz", t), -0.005 * t, 1e-6);
  }
}

TEST_P(UniformStates, Case1BHeldUniaxialStrain) {
  const Outcome outcome = run(R"(
    [[supports]]
    on = "x1"
    displacement = { x = 0.1 }
    )",
                              decades);
  EXPECT_RELATIVE(outcome.history.at("sxx", 0), 200.0, 1e-9);
  for (const double t : decade_times) {
    const double exact = reference::held_uniaxial(reference::nafems, 200, t);
    EXPECT_RELATIVE(outcome.history.at("sxx", t), exact, 1e-4);
    EXPECT_RELATIVE(outcome.history.at("sxx_max", t), exact, 1e-4);
  }
  EXPECT_RELATIVE(outcome.history.at("sxx", 1000), 14.14, 5e-4);  // as published
}

TEST_P(UniformStates, Case3AConstantShear) {
  const Outcome outcome = run(R"(
    [[loads]]
    on = "x1"
    pressure = -200
    [[loads]]
    on = "y1"
    traction = [0, -200, 0]
    )",
                              "[1, 1000]");
  EXPECT_RELATIVE(outcome.history.at("cxx", 1), 0.135, 1e-6);
  EXPECT_RELATIVE(outcome.history.at("cxx", 1000), 135, 1e-6);
  EXPECT_RELATIVE(outcome.history.at("cyy", 1000), -135, 1e-6);
}

TEST_P(UniformStates, Case3BHeldShear) {
  const Outcome outcome = run(R"(
    [[supports]]
    on = "x1"
    displacement = { x = 0.1 }
    [[supports]]
    on = "y1"
    displacement = { y = -0.1 }
    )",
                              decades);
  for (const double t : decade_times)
    EXPECT_RELATIVE(outcome.history.at("sxx", t), reference::held_shear(reference::nafems, 200 / 1.3, t), 1e-4);
  EXPECT_RELATIVE(outcome.history.at("sxx", 0.1), 77.48, 1e-4);
}

TEST_P(UniformStates, Case5APlaneStrainUnderLoads) {
  const Outcome outcome = run(R"(
    [[supports]]
    on = "z1"
    displacement = { z = 0 }
    [[loads]]
    on = "x1"
    pressure = -200
    [[loads]]
    on = "y1"
    pressure = -100
    )",
                              "[1000]");
  const auto exact = reference::plane_strain_creep(reference::nafems, 200, 100, 1000);
  EXPECT_RELATIVE(outcome.history.at("szz", 1000), exact.sigma_z, 1e-4);
  EXPECT_RELATIVE(outcome.history.at("cxx", 1000), exact.creep_x, 1e-4);
  EXPECT_RELATIVE(outcome.history.at("cyy", 1000), exact.creep_y, 1e-4);
  EXPECT_RELATIVE(outcome.history.at("czz", 1000), exact.creep_z, 1e-4);
  EXPECT_RELATIVE(outcome.history.at("cxx", 1000), 0.13212, 1e-4);
}

TEST_P(UniformStates, Case5BHeldTriaxialStrain) {
  const Outcome outcome = run(R"(
    [[supports]]
    on = "x1"
    displacement = { x = 0.1 }
    [[supports]]
    on = "y1"
    displacement = { y = 0.05 }
    [[supports]]
    on = "z1"
    displacement = { z = 0 }
    )",
                              decades);
  for (const double t : decade_times)
    EXPECT_RELATIVE(outcome.history.at("sxx", t), reference::held_triaxial(reference::nafems, 1e-3, t), 1e-4);
  EXPECT_RELATIVE(outcome.history.at("sxx", 0.1), 315.44, 1e-4);
  EXPECT_RELATIVE(outcome.history.at("sxx", 1000), 257.88, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Elements, UniformStates,
                         testing::Values(std::pair<std::string, int>{"hex", 1}, std::pair<std::string, int>{"hex", 2},
                                         std::pair<std::string, int>{"wedge", 2},
                                         std::pair<std::string, int>{"tet", 2}),
                         [](const auto& parameter) {
                           return parameter.param.first + std::to_string(parameter.param.second);
                         });

// VM132 (Timoshenko): a bolt of initial stress 1000 psi, its ends held.
TEST(Bolt, RelaxesByTheClosedForm) {
  const Outcome outcome = test::run_case(
      configuration(R"(
    [[supports]]
    on = "x1"
    displacement = { x = 3.3333333333333333e-3 }
    )",
                    "[190, 420, 690, 880, 950]"),
      cube("hex"),
      {"materials.steel.young_modulus=30e6", "materials.steel.creep.0.A=4.8e-30", "materials.steel.creep.0.n=7"});
  const std::vector<std::pair<double, double>> published{
      {190, 974.98}, {420, 949.71}, {690, 925.03}, {880, 910.06}, {950, 904.95}};
  for (const auto& [t, stress] : published) EXPECT_RELATIVE(outcome.history.at("sxx", t), stress, 1e-4);
}

}  // namespace
}  // namespace creepcontact
