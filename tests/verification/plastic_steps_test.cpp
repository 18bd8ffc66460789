// What happens to plastic flow inside steps, at jumps of the loads, and over cycles. Unless said otherwise E = 1000,
// yield stress 1.

#include <cmath>

#include "verification/plastic_models.hpp"

namespace creepcontact {
namespace plastic_steps_tests {
namespace {

using namespace test;

const std::string wall_geo = regions_geo({{"wall", {1, 2, 20}, {0, 0.05, 1}}});

// Compressible: the axial stress comes into play as the plastic zone grows, and the way of the stress bends.
std::string compressible_toml(const std::string& pressure, const std::string& time) {
  std::string toml = cylinder_toml("", pressure, time);
  toml.replace(toml.find("0.4999"), 6, "0.3");
  return toml;
}

double bore_at(const Outcome& wall, double t) {
  return wall.history.at("bore", t);
}

// A load that jumps grows in parts, as the first one does.
TEST(PlasticSteps, LoadsThatJumpGrowAsTheFirstOnes) {
  const Outcome slow = run_case(compressible_toml(R"({ t = [0, 1], values = [0, 0.75] })", "end = 1\ntolerance = 1e-5"),
                                wall_geo),
                at_once = run_case(compressible_toml("0.75", "end = 1"), wall_geo),
                later = run_case(compressible_toml(R"({ t = [0, 1, 1, 2], values = [0, 0, 0.75, 0.75] })", "end = 2"),
                                 wall_geo);
  EXPECT_NEAR(bore_at(at_once, 1), bore_at(slow, 1), 1e-3);
  EXPECT_NEAR(bore_at(later, 2), bore_at(at_once, 1), 1e-6);
  EXPECT_GT(later.summary.number("plastic_error"), 1e-5) << "what its parts leave is estimated";
}

// Steps in which the return errs are followed in parts: the error stays with the tolerance.
TEST(PlasticSteps, ErrorOfTheReturnFollowsTheTolerance) {
  const std::string pressure = R"({ t = [0, 1], values = [0, 0.75] })";
  const auto run = [&](const char* tolerance) {
    return run_case(compressible_toml(pressure, std::string("end = 1\ntolerance = ") + tolerance), wall_geo);
  };
  const Outcome fine = run("1e-7"), usual = run("1e-4"), loose = run("1e-2");
  EXPECT_NEAR(bore_at(loose, 1), bore_at(fine, 1), 5e-3);
  EXPECT_NEAR(bore_at(usual, 1), bore_at(fine, 1), 3e-4);
  EXPECT_GT(usual.summary.number("elastic_solves"), loose.summary.number("elastic_solves"));
}

// Where creep and flow last together, an implicit method whose Jacobian knows of the flow takes long steps.
TEST(PlasticSteps, ImplicitMethodsGoOnToFlow) {
  const std::string creep = "[[materials.alloy.creep]]\nlaw = \"norton\"\nA = 3e-4\nn = 5\n";
  const std::string toml =
      cylinder_toml(creep, R"({ t = [0, 1e-3, 3000], values = [0, 0.75, 0.75] })", "end = 3000\ntolerance = 1e-3");
  const Outcome wall = run_case(toml, wall_geo, {"time.integrator=cvode_bdf"});
  EXPECT_NEAR(bore_at(wall, 3000), 0.404717, 1e-3);
  EXPECT_LT(wall.summary.number("steps"), 110) << "150 with elastic moduli";
}

// Smooth waves: steps end at all turns where something yields, however many there are.
TEST(PlasticCycles, AllTurnsOfALongWaveAreMet) {
  const Outcome strip = run_strip(0.7, 1.25, "end = 100\noutput = [50, 99]");
  const double per_cycle = 2 * 1.25 * (1 - 2 * std::sqrt(0.3 / 1.25));
  EXPECT_RELATIVE(1000 * (strip.history.at("strain", 99) - strip.history.at("strain", 50)) / 49, per_cycle, 2e-3);
}

// Jumps carry the growth on: 100 cycles, of which a few are computed.
TEST(PlasticCycles, JumpsPassOverRatcheting) {
  const std::string creep = "creep = [{ law = \"norton\", A = 1e-30, n = 2 }]";
  const std::string cycles = "end = 100\noutput = [50, 99]\ncycle = 1\n";
  const Outcome computed = run_strip(0.7, 1.25, cycles, creep);
  const Outcome jumped = run_strip(0.7, 1.25, cycles + "jump_cycles = true", creep);
  EXPECT_RELATIVE(jumped.history.at("strain", 100), computed.history.at("strain", 100), 1e-3);
  EXPECT_GT(jumped.summary.number("cycles/jumps"), 1);
  EXPECT_LT(jumped.summary.number("cycles/computed"), 90);
}

// Ranges of a cycle have the plastic strain, and cycles need no creep.
TEST(PlasticCycles, RangesOfStrainHaveThePlasticOnes) {
  const CaseDirectory directory(strip_geo);
  const std::string out = (directory.path() / "out").string();
  ASSERT_EQ(run::run(directory.config(strip_toml(0.2, 3, "end = 6\ncycle = 1"), {}), {.output = out}).exit_status, 0);
  const Table cycles(std::filesystem::path(out) / "cycles.csv");
  // At the surfaces the stress goes from yield to yield, and what is left of Y = 3 is plastic. The outermost points lie
  // 0.6 % within. Ranges are those of deviators: 2/3 (1 + nu) of the elastic strain.
  EXPECT_NEAR(1000 * cycles.column("strip.inelastic_strain_range").back(), 3 - 2, 3e-2);
  EXPECT_NEAR(1000 * cycles.column("strip.strain_range").back(), 3 - 2 + 2 * 2.0 / 3, 3e-2);
}

}  // namespace
}  // namespace plastic_steps_tests
}  // namespace creepcontact
