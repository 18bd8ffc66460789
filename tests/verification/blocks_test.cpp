/// Two blocks in series, pressed and held: the closed form of their relaxation on matching and other meshes, and all
/// integrators against it.

#include <fmt/format.h>

#include "creepcontact/ode/integrator.hpp"
#include "verification/case.hpp"
#include "verification/reference/relaxation.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace blocks_tests {
namespace {

using test::Outcome;

constexpr double n = 4, strain = 1e-3;
constexpr reference::Bar lower{10, 2e5, 1e-14}, upper{20, 1e5, 3e-14};

/// Boxes 10 x 10 in cross section; divisions of the joint's sides.
std::string geo(int lower_divisions, int upper_divisions, const std::string& kind) {
  std::string text = "SetFactory(\"OpenCASCADE\"); x[] = {}; y[] = {};\n";
  const auto box = [&](const char* name, double z, double height, int divisions) {
    text += fmt::format(R"(
      p1 = newp; Point(p1) = {{0, 0, {1}}}; p2 = newp; Point(p2) = {{10, 0, {1}}};
      p3 = newp; Point(p3) = {{10, 10, {1}}}; p4 = newp; Point(p4) = {{0, 10, {1}}};
      l1 = newl; Line(l1) = {{p1, p2}}; l2 = newl; Line(l2) = {{p2, p3}};
      l3 = newl; Line(l3) = {{p3, p4}}; l4 = newl; Line(l4) = {{p4, p1}};
      loop = newll; Line Loop(loop) = {{l1, l2, l3, l4}}; s = news; Plane Surface(s) = {{loop}};
      Transfinite Curve{{l1, l2, l3, l4}} = {3} + 1; Transfinite Surface{{s}}; {4}
      out[] = Extrude {{0, 0, {2}}} {{ Surface{{s}}; {5} }};
      Physical Volume("{0}") = {{out[1]}};
      Physical Surface("{0}_bottom") = {{s}}; Physical Surface("{0}_top") = {{out[0]}};
      y[] += {{out[2]}}; x[] += {{out[5]}};
    )",
                        name, z, height, divisions, kind == "hex" ? "Recombine Surface{s};" : "",
                        kind == "hex" ? "Layers{2}; Recombine;" : "");
  };
  box("lower", 0, lower.length, lower_divisions);
  box("upper", lower.length, upper.length, upper_divisions);
  return text + "Physical Surface(\"x0\") = {x[]}; Physical Surface(\"y0\") = {y[]};\n";
}

const std::vector<double> times{1, 10, 100, 1e3, 1e4};

double initial_stress() {
  const double squeeze = strain * (lower.length + upper.length);
  return squeeze / (lower.length / lower.young_modulus + upper.length / upper.young_modulus);
}

std::string configuration(const std::string& time) {
  return "[mesh]\nfile = \"case.geo\"\n" + test::body("lower", lower.young_modulus, 0.3, lower.A, n) +
         test::body("upper", upper.young_modulus, 0.3, upper.A, n) + R"(
    [[supports]]
    on = "x0"
    displacement = { x = 0 }
    [[supports]]
    on = "y0"
    displacement = { y = 0 }
    [[supports]]
    on = "lower_bottom"
    displacement = { z = 0 }
    [[supports]]
    on = "upper_top"
    displacement = { z = -0.03 }
    [[contacts]]
    name = "joint"
    between = ["lower_top", "upper_bottom"]
    )" + time +
         test::probe("mean", "contact_pressure", "on = \"lower_top\"") +
         test::probe("min", "contact_pressure", "on = \"lower_top\"\nreduce = \"min\"") +
         test::probe("max", "contact_pressure", "on = \"lower_top\"\nreduce = \"max\"") +
         test::probe("reaction", "reaction_z", "on = \"upper_top\"");
}

struct Meshes {
  std::string name, kind;
  int order, lower_divisions, upper_divisions;
};

class BlocksInSeries : public testing::TestWithParam<Meshes> {};

TEST_P(BlocksInSeries, RelaxByTheClosedForm) {
  const Meshes& meshes = GetParam();
  const Outcome outcome = test::run_case(
      configuration("[time]\nend = 1e4\ntolerance = 1e-6\noutput = [1, 10, 100, 1e3, 1e4]\n"),
      geo(meshes.lower_divisions, meshes.upper_divisions, meshes.kind), {"mesh.order=" + std::to_string(meshes.order)});
  for (const double t : times) {
    const double exact = reference::blocks_in_series(lower, upper, n, initial_stress(), t);
    EXPECT_RELATIVE(outcome.history.at("mean", t), exact, 1e-4);
    EXPECT_RELATIVE(outcome.history.at("max", t), exact, 1e-3);
    EXPECT_RELATIVE(outcome.history.at("min", t), exact, 1e-3);
    EXPECT_RELATIVE(outcome.history.at("reaction", t), -100 * exact, 1e-4);
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, BlocksInSeries,
                         testing::Values(Meshes{"matching_hex8", "hex", 1, 3, 3}, Meshes{"hex8", "hex", 1, 3, 2},
                                         Meshes{"matching_hex20", "hex", 2, 2, 2}, Meshes{"hex20", "hex", 2, 2, 3},
                                         Meshes{"tet10", "tet", 2, 2, 3}),
                         [](const auto& parameter) { return parameter.param.name; });

class EveryIntegrator : public testing::TestWithParam<std::string> {};

TEST_P(EveryIntegrator, AgreesWithTheClosedForm) {
  const bool euler = GetParam().ends_with("euler");
  const std::string time = "[time]\nend = 100\noutput = [1, 10, 100]\nintegrator = \"" + GetParam() + "\"\n" +
                           (euler ? "step = 0.05\n" : "tolerance = 1e-4\n");
  const Outcome outcome = test::run_case(configuration(time), geo(2, 1, "hex"), {"mesh.order=1"});
  for (const double t : {1.0, 10.0, 100.0})
    EXPECT_RELATIVE(outcome.history.at("mean", t), reference::blocks_in_series(lower, upper, n, initial_stress(), t),
                    euler ? 2e-3 : 3e-4);
}

std::vector<std::string> integrator_names() {
  std::vector<std::string> names;
  for (const ode::IntegratorInfo& info : ode::integrators())
    if (!info.isochronous) names.push_back(info.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Integrators, EveryIntegrator, testing::ValuesIn(integrator_names()),
                         [](const auto& parameter) { return parameter.param; });

/// Observed order of an Euler scheme on the first hour, by halving the step.
double observed_order(const std::string& scheme) {
  const double exact = reference::blocks_in_series(lower, upper, n, initial_stress(), 1);
  std::vector<double> errors;
  for (const double step : {0.1, 0.05}) {
    const Outcome outcome = test::run_case(
        configuration(fmt::format("[time]\nend = 1\ninner_tolerance = 1e-13\nstep = {}\n{}\n", step, scheme)),
        geo(1, 1, "hex"), {"mesh.order=1"});
    errors.push_back(std::abs(outcome.history.at("mean", 1) - exact));
  }
  return std::log2(errors[0] / errors[1]);
}

TEST(EulerSchemes, HaveTheirOrderInContactProblems) {
  EXPECT_NEAR(observed_order("integrator = \"explicit_euler\""), 1, 0.1);
  EXPECT_NEAR(observed_order("integrator = \"beta_euler\"\nbeta = 1.0"), 1, 0.1);
  EXPECT_NEAR(observed_order("integrator = \"beta_euler\"\nbeta = 0.5"), 2, 0.1);
}

}  // namespace
}  // namespace blocks_tests
}  // namespace creepcontact
