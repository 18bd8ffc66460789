// Linear viscoelastic laws: creep, recovery and relaxation against closed forms.

#include <algorithm>
#include <cmath>

#include "verification/cube.hpp"

namespace creepcontact {
namespace {

using namespace test;

const std::string on_and_off = pulled("{ t = [0, 10, 10], values = [100, 100, 0] }");
const std::string time_keys = "end = 40\noutput = [1, 5, 10, 12, 20, 40]\ntolerance = 1e-6\n";
const double output_times[] = {1, 5, 10, 12, 20, 40};

double kelvin(double t, double compliance, double time) {
  return t > 0 ? compliance * (1 - std::exp(-t / time)) : 0.0;
}

TEST(Viscoelastic, KelvinVoigtCreepsAndRecovers) {
  const Outcome outcome =
      run_cube(creep_law_table("kelvin_voigt", "compliance = 2e-5\ntime = 4"), on_and_off, time_keys);
  for (const double t : output_times) {
    const double exact = 100 * (kelvin(t, 2e-5, 4) - kelvin(t - 10, 2e-5, 4));
    EXPECT_NEAR(outcome.history.at("cxx", t), exact, 2e-9) << t;
    EXPECT_NEAR(outcome.history.at("cyy", t), -exact / 2, 2e-9) << t;
  }
}

TEST(Viscoelastic, BurgersIsMaxwellAndKelvinInSeries) {
  const Outcome outcome =
      run_cube(creep_law_table("burgers", "viscosity = 1e6\ncompliance = 2e-5\ntime = 4"), on_and_off, time_keys);
  for (const double t : output_times) {
    const double exact = 100 * (std::min(t, 10.0) / 1e6 + kelvin(t, 2e-5, 4) - kelvin(t - 10, 2e-5, 4));
    EXPECT_NEAR(outcome.history.at("cxx", t), exact, 2e-9) << t;
  }
}

TEST(Viscoelastic, MaxwellRelaxesExponentially) {
  const Outcome outcome = run_cube(creep_law_table("maxwell", "viscosity = 1e6"), support("x1", "x", "0.1"), time_keys);
  for (const double t : output_times)
    EXPECT_RELATIVE(outcome.history.at("sxx", t), 200 * std::exp(-t * 200e3 / 1e6), 1e-4 * std::max(1.0, t));
}

/// A chain with times over six decades: the fast ones make it stiff. The standard solid relaxes to E / (1 + E J).
TEST(Viscoelastic, PronyChainWithTimesOverDecades) {
  const std::string chain = creep_law_table("hereditary", "compliances = [1e-6, 2e-6, 3e-6]\ntimes = [1e-3, 1, 1e3]");
  const Outcome pulled_cube =
      run_cube(chain, pulled("100"), "end = 1e4\noutput = [1e-2, 1, 100, 1e4]\ntolerance = 1e-5\n");
  for (const double t : {1e-2, 1.0, 100.0, 1e4})
    EXPECT_NEAR(pulled_cube.history.at("cxx", t),
                100 * (kelvin(t, 1e-6, 1e-3) + kelvin(t, 2e-6, 1) + kelvin(t, 3e-6, 1e3)), 2e-8)
        << t;
  const Outcome relaxed = run_cube(chain, support("x1", "x", "0.1"), "end = 1e5\noutput = [1e5]\ntolerance = 1e-5\n");
  EXPECT_RELATIVE(relaxed.history.at("sxx", 1e5), 200 / (1 + 200e3 * 6e-6), 1e-4);
  EXPECT_LT(relaxed.summary.number("elastic_solves"), 700);
}

TEST(Viscoelastic, VolumetricPartFollowsTheMeanStress) {
  const Outcome outcome =
      run_cube(creep_law_table("hereditary", "compliances = [2e-5]\ntimes = [4]\nvolumetric_compliances = [6e-6]"),
               pulled("90"), time_keys);
  for (const double t : output_times) {
    const double shape = 90 * kelvin(t, 2e-5, 4), volume = 30 * kelvin(t, 6e-6, 4);
    EXPECT_NEAR(outcome.history.at("cxx", t), shape + volume / 3, 2e-9) << t;
    EXPECT_NEAR(outcome.history.at("cyy", t), -shape / 2 + volume / 3, 2e-9) << t;
  }
}

/// Under a constant load the theories agree; after a step down ageing forgets what was, heredity does not.
TEST(Viscoelastic, AgeingAndHeredityAgreeUnderConstantLoadAndDifferAfterAStep) {
  const std::string ageing = creep_law_table("ageing", "A = 1e-6\nn = 1\nm = 1");
  const std::string fluid = creep_law_table("maxwell", "viscosity = 1e6");
  const std::string iso = time_keys + "integrator = \"isochronous\"\n";
  const auto constant = run_cube(ageing, pulled("100"), iso),
             constant_heredity = run_cube(fluid, pulled("100"), time_keys);
  for (const double t : output_times)
    EXPECT_RELATIVE(constant.history.at("cxx", t), constant_heredity.history.at("cxx", t), 1e-5);
  const std::string down = pulled("{ t = [0, 10, 10], values = [100, 100, 50] }");
  const auto aged = run_cube(ageing, down, iso), remembered = run_cube(fluid, down, time_keys);
  EXPECT_RELATIVE(aged.history.at("cxx", 40), 1e-6 * 50 * 40, 1e-6);
  EXPECT_RELATIVE(remembered.history.at("cxx", 40), 1e-6 * (100 * 10 + 50 * 30), 1e-5);
}

}  // namespace
}  // namespace creepcontact
