// Primary creep in uniform states: NAFEMS R0027 10A, 10B, and loads that step, where theories differ.

#include <cmath>

#include "creepcontact/ode/integrator.hpp"
#include "verification/cube.hpp"

namespace creepcontact {
namespace {

using namespace test;

const std::string nafems = "A = 3.125e-14\nn = 5.0\nm = 0.5";
const std::string shear_loads = pulled("200") + "\n[[loads]]\non = \"y1\"\ntraction = [0, -200, 0]\n";
const std::string shear_held = support("x1", "x", "0.1") + support("y1", "y", "-0.1");

std::string times(const std::string& outputs, const std::string& integrator = "auto", double tolerance = 1e-5) {
  return "end = 1000\noutput = " + outputs + "\nintegrator = \"" + integrator +
         "\"\ntolerance = " + std::to_string(tolerance) + "\n";
}

class PrimaryLaws : public testing::TestWithParam<std::string> {};

TEST_P(PrimaryLaws, Case10AConstantShear) {
  const Outcome outcome = run_cube(creep_law_table(GetParam(), nafems), shear_loads, times("[1e-3, 1, 1000]"));
  for (const double t : {1e-3, 1.0, 1000.0}) EXPECT_RELATIVE(outcome.history.at("cxx", t), 0.135 * std::sqrt(t), 1e-6);
  EXPECT_RELATIVE(outcome.history.at("cxx", 1000), 4.2691, 1e-4);
}

TEST_P(PrimaryLaws, Case10BHeldShear) {
  const Outcome outcome = run_cube(creep_law_table(GetParam(), nafems), shear_held, times("[50, 100, 500, 1000]"));
  const std::vector<double> published = GetParam() == "time_hardening"
                                            ? std::vector<double>{27.16, 24.91, 20.37, 18.68}
                                            : std::vector<double>{36.63, 34.02, 28.61, 26.54};
  const double at[] = {50, 100, 500, 1000};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_RELATIVE(outcome.history.at("sxx", at[i]), published[i], 5e-4);
}

INSTANTIATE_TEST_SUITE_P(Laws, PrimaryLaws, testing::Values("time_hardening", "strain_hardening"),
                         [](const auto& law) { return law.param; });

class SingularStarts : public testing::TestWithParam<std::string> {};

/// No integrator needs a first step made by hand.
TEST_P(SingularStarts, EveryIntegratorRelaxesBothPrimaryLaws) {
  for (const auto& [law, exact] : {std::pair{"time_hardening", 18.6806}, std::pair{"strain_hardening", 26.5434}}) {
    std::string time = times("[1, 1000]", GetParam(), 1e-4);
    if (GetParam() == "explicit_euler") time += "step = \"stable\"\nstep_factor = 0.005\n";
    if (GetParam() == "beta_euler") time += "step = \"stable\"\nstep_factor = 0.05\nbeta = 0.5\n";
    const Outcome outcome = run_cube(creep_law_table(law, nafems), shear_held, time);
    EXPECT_RELATIVE(outcome.history.at("sxx", 1000), exact, 1e-3);
  }
}

std::vector<std::string> integrators_of_rates() {
  std::vector<std::string> names;
  for (const ode::IntegratorInfo& info : ode::integrators())
    if (!info.isochronous) names.push_back(info.name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(All, SingularStarts, testing::ValuesIn(integrators_of_rates()),
                         [](const auto& name) { return name.param; });

/// Stress 150, 200 after 100 h, 100 after 300 h, -150 after 600 h.
const std::string steps =
    pulled("{ t = [0, 100, 100, 300, 300, 600, 600], values = [150, 150, 200, 200, 100, 100, -150] }");
struct Piece {
  double begin, end, stress;
};
const Piece pieces[] = {{0, 100, 150}, {100, 300, 200}, {300, 600, 100}, {600, 1000, -150}};
double flow(double stress) {
  return 3.125e-14 * std::pow(std::abs(stress), 5);
}

TEST(PrimaryCreep, StrainHardeningUnderSteppedAndReversedLoad) {
  const Outcome outcome =
      run_cube(creep_law_table("strain_hardening", nafems), steps, times("[50, 100, 200, 300, 600, 601, 1000]"));
  double accumulated = 0, strain = 0;
  for (const Piece& piece : pieces) {
    const double before = accumulated;
    accumulated = std::sqrt(before * before + std::pow(flow(piece.stress), 2) * (piece.end - piece.begin));
    strain += std::copysign(accumulated - before, piece.stress);
    EXPECT_NEAR(outcome.history.at("cxx", piece.end), strain, 1e-5 * accumulated) << piece.end;
    EXPECT_NEAR(outcome.history.at("cyy", piece.end), -strain / 2, 1e-5 * accumulated) << piece.end;
  }
}

TEST(PrimaryCreep, TimeHardeningUnderSteppedAndReversedLoad) {
  const Outcome outcome = run_cube(creep_law_table("time_hardening", nafems), steps, times("[100, 300, 600, 1000]"));
  double strain = 0;
  for (const Piece& piece : pieces) {
    strain += std::copysign(flow(piece.stress), piece.stress) * (std::sqrt(piece.end) - std::sqrt(piece.begin));
    EXPECT_NEAR(outcome.history.at("cxx", piece.end), strain, 1e-5 * 0.3) << piece.end;
  }
}

TEST(PrimaryCreep, AJumpOfTheLoadOnAVirginBodyStartsSingularLater) {
  const Outcome outcome = run_cube(creep_law_table("strain_hardening", nafems),
                                   pulled("{ t = [0, 100, 100], values = [0, 0, 200] }"), times("[100, 101, 1000]"));
  EXPECT_EQ(outcome.history.at("cxx", 100), 0.0);
  for (const double t : {101.0, 1000.0}) EXPECT_RELATIVE(outcome.history.at("cxx", t), 0.01 * std::sqrt(t - 100), 1e-5);
}

TEST(PrimaryCreep, ARampFromZeroNeedsNoBreakpoint) {
  const Outcome outcome = run_cube(creep_law_table("strain_hardening", nafems), pulled("\"200*t/1000\""),
                                   times("[100, 1000]", "auto", 1e-6));
  // eps^2 = integral (A (0.2 t)^5)^2 dt
  for (const double t : {100.0, 1000.0})
    EXPECT_NEAR(outcome.history.at("cxx", t), flow(0.2 * t) * std::sqrt(t / 11),
                2e-6 * flow(0.2 * t) * std::sqrt(t) + 1e-8);
}

/// Where a virgin point is loaded slowly, Newton's corrections must not pass for nothing.
TEST(PrimaryCreep, SlowRampsFromZeroCreepWithEveryIntegratorOfHighOrder) {
  const std::string law = creep_law_table("strain_hardening", "A = 1e-11\nn = 3.5\nm = 0.35");
  const double unit = 100 / 200e3;
  for (const char* integrator : {"auto", "cvode_bdf", "cvode_adams", "log_adams", "arkode_erk", "arkode_dirk"})
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
      const Outcome outcome = run_cube(law, pulled("\"100*min(t/50, 1)\""),
                                       "end = 60\noutput = [50]\nintegrator = \"" + std::string(integrator) +
                                           "\"\ntolerance = " + std::to_string(tolerance) + "\n");
      // eps^(1/m) = integral (A (2 t)^n)^(1/m) dt
      const double exact = 1e-11 * std::pow(100.0, 3.5) * std::pow(50 / (3.5 / 0.35 + 1), 0.35);
      EXPECT_NEAR(outcome.history.at("cxx", 50), exact, 3 * tolerance * unit) << integrator << ", " << tolerance;
    }
}

TEST(PrimaryCreep, PrimaryAndSecondaryAdd) {
  for (const char* law : {"time_hardening", "strain_hardening"}) {
    const Outcome outcome = run_cube(creep_law_table(law, nafems) + creep_law_table("norton", "A = 3.125e-14\nn = 5.0"),
                                     pulled("200"), times("[1, 1000]"));
    for (const double t : {1.0, 1000.0}) EXPECT_RELATIVE(outcome.history.at("cxx", t), 0.01 * (std::sqrt(t) + t), 1e-6);
  }
  const Outcome terms = run_cube(
      creep_law_table("graham_walles", "A = [1e-14, 1e-15, 1e-20]\nn = [5, 5, 5]\nm = [0.33333333333333333, 1, 3]"),
      pulled("200"), times("[1, 1000]"));
  const double q5 = std::pow(200.0, 5);
  EXPECT_RELATIVE(terms.history.at("cxx", 1000), q5 * (1e-14 * 10 + 1e-15 * 1e3 + 1e-20 * 1e9), 1e-6);
}

/// One linear element whose nodes are all held: there are no equations to solve, but a stress that relaxes.
TEST(PrimaryCreep, ACubeHeldOnAllSidesRelaxes) {
  const Outcome outcome =
      run_cube(creep_law_table("norton", "A = 3.125e-14\nn = 5"),
               support("x1", "x", "0.1") + support("y1", "y", "0.05") + support("z1", "z", "0"), times("[1000]"));
  EXPECT_RELATIVE(outcome.history.at("sxx", 1000), 257.88, 1e-4);  // NAFEMS R0027 5B
}

TEST(PrimaryCreep, AgeingSolvesTheIsochronousCurve) {
  const Outcome outcome =
      run_cube(creep_law_table("ageing", nafems), support("x1", "x", "0.1"), times("[1, 10, 1000]", "isochronous"));
  for (const double t : {1.0, 10.0, 1000.0}) {
    const double stress = outcome.history.at("sxx", t);
    EXPECT_RELATIVE(stress / 200e3 + flow(stress) * std::sqrt(t), 1e-3, 1e-7);
  }
  const Outcome stepped =
      run_cube(creep_law_table("ageing", nafems), steps, times("[50, 100, 600, 1000]", "isochronous"));
  // At a jump the result is that after it.
  EXPECT_RELATIVE(stepped.history.at("cxx", 50), flow(150) * std::sqrt(50.0), 1e-9);
  EXPECT_RELATIVE(stepped.history.at("cxx", 100), flow(200) * 10, 1e-9);
  EXPECT_RELATIVE(stepped.history.at("cxx", 1000), -flow(150) * std::sqrt(1000.0), 1e-9);
}

/// A rate written by the user is the law it stands for.
TEST(PrimaryCreep, ExpressionsAgreeWithTheLawsTheyWriteOut) {
  const Outcome norton =
      run_cube(creep_law_table("expression", "rate = \"3.125e-14*q^5\""), pulled("200"), times("[1000]"));
  EXPECT_RELATIVE(norton.history.at("cxx", 1000), 10.0, 1e-6);
  const Outcome time =
      run_cube(creep_law_table("expression", "rate = \"0.5*3.125e-14*q^5*t^(-0.5)\""), shear_held, times("[1000]"));
  EXPECT_RELATIVE(time.history.at("sxx", 1000), 18.6806, 1e-4);
  const Outcome strain =
      run_cube(creep_law_table("expression", "rate = \"0.5*(3.125e-14*q^5)^2/eps\""), shear_held, times("[1000]"));
  EXPECT_RELATIVE(strain.history.at("sxx", 1000), 26.5434, 1e-4);
}

}  // namespace
}  // namespace creepcontact
