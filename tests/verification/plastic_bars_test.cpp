/// Three parallel bars of equal stiffness that yield one after the other, at 1, 1.5 and 2: E eps = F/3 up to F = 3,
/// (F - 1)/2 up to 4, F - 2.5 up to the limit load of 4.5.

#include <fmt/format.h>

#include "support/says.hpp"
#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace plastic_bars_tests {
namespace {

using namespace test;

constexpr double modulus = 1000;
const std::vector<std::pair<std::string, double>> bars{{"weak", 1}, {"middle", 1.5}, {"strong", 2}};

double strain(double force) {
  return (force <= 3 ? force / 3 : force <= 4 ? (force - 1) / 2 : force - 2.5) / modulus;
}

/// @param poisson_ratio  zero where contact must not bend what it presses
std::string materials(double poisson_ratio) {
  std::string toml;
  for (const auto& [name, yield] : bars)
    toml += body(name, modulus, poisson_ratio) + fmt::format("plasticity = {{ yield_stress = {} }}\n", yield);
  return toml;
}

/// Bars of section 1 whose ends move together, under an axial force.
Outcome pull(const std::string& force, const std::string& time, bool fails = false) {
  std::string toml = section_of("generalized_plane_strain", 1) + materials(0.3) +
                     "[generalized_plane_strain]\nforce = " + force + "\n[time]\n" + time + "\n" +
                     probe("strain", "axial_strain", "body = \"weak\"");
  std::vector<Region> regions;
  for (const auto& [name, yield] : bars) {
    const double x = 2 * static_cast<double>(regions.size());
    regions.push_back({name, {x, x + 1, 1}, {0, 1, 1}});
    toml +=
        support(name + "_x0", "x") + support(name + "_y0", "y") + probe(name, "stress_zz", "body = \"" + name + "\"");
  }
  return fails ? run_to_failure(toml, regions_geo(regions)) : run_case(toml, regions_geo(regions));
}

TEST(PlasticBars, YieldOneAfterTheOther) {
  const Table history =
      pull("{ t = [0, 4.4], values = [0, 4.4] }", "end = 4.4\noutput = [1.5, 3.2, 3.7, 4.2]\ntolerance = 1e-6").history;
  for (const double force : {1.5, 3.2, 3.7, 4.2, 4.4}) {
    EXPECT_NEAR(history.at("strain", force), strain(force), 1e-7 * strain(force)) << force;
    for (const auto& [name, yield] : bars)
      EXPECT_NEAR(history.at(name, force), std::min(yield, modulus * strain(force)), 1e-6) << name << force;
  }
}

/// On the way back all are elastic; the strain that stays is what the stresses of opposite signs allow.
TEST(PlasticBars, KeepStressesWhenUnloaded) {
  const Table history =
      pull("{ t = [0, 1, 2], values = [0, 4.2, 0] }", "end = 2\noutput = [1.5]\ntolerance = 1e-6").history;
  EXPECT_NEAR(history.at("strain", 1.5), strain(4.2) - 2.1 / 3 / modulus, 1e-9);
  EXPECT_NEAR(history.at("strain", 2), strain(4.2) - 4.2 / 3 / modulus, 1e-9);
  for (const auto& [name, yield] : bars)
    EXPECT_NEAR(history.at(name, 2), std::min(yield, modulus * strain(4.2)) - 1.4, 1e-6) << name;
}

TEST(PlasticBars, AllAtOnceIsTheSameAsLittleByLittle) {
  const Table history = pull("4.2", "end = 1\ntolerance = 1e-6").history;
  EXPECT_NEAR(history.at("strain", 0), strain(4.2), 1e-7 * strain(4.2));
  EXPECT_NEAR(history.at("strain", 1), strain(4.2), 1e-7 * strain(4.2));
}

TEST(PlasticBars, CannotCarryMoreThanTheirLimitLoad) {
  const Outcome outcome = pull("{ t = [0, 1], values = [0, 5] }", "end = 1", true);
  EXPECT_EQ(outcome.exit_status, 4);
  // How far it flows in the last step, or without limit, depends on rounding: beyond the limit load nothing holds it.
  EXPECT_TRUE(says(outcome.message, {"cannot be carried", "flows", "yield stress"})) << outcome.message;
  EXPECT_NEAR(5 * outcome.summary.number("time_reached"), 4.5, 1e-3);
}

/// The same as columns on which a stiff plate rests that nothing but they hold.
TEST(PlasticBars, CarryAPlateThatRestsOnThem) {
  std::vector<Box> boxes{{"plate", {0, 0, 1}, {5, 1, 1}, {10, 2, 2}}};
  std::string toml = "[mesh]\nfile = \"case.geo\"\norder = 1\n" + materials(0) + body("plate", 1e9, 0) +
                     support("plate_x0", "x") + support("plate_y0", "y") +
                     "[[loads]]\non = \"plate_z1\"\npressure = { t = [0, 4.3], values = [0, 0.86] }\n" +
                     "[time]\nend = 4.3\noutput = [1.5, 3.2, 3.7, 4.2]\ntolerance = 1e-6\n" +
                     probe("plate", "displacement_z", "on = \"plate_z0\"\nreduce = \"mean\"");
  for (const auto& [name, yield] : bars) {
    boxes.push_back({name, {2 * static_cast<double>(boxes.size() - 1), 0, 0}, {1, 1, 1}, {1, 1, 2}});
    toml += support(name + "_x0", "x") + support(name + "_y0", "y") + support(name + "_z0", "z") +
            contact_table(name + "_z1", "plate_z0", "slave = \"" + name + "_z1\"") +
            probe(name, "contact_force_z", "on = \"" + name + "_z1\"");
  }
  const Table history = run_case(toml, boxes_geo(boxes)).history;
  for (const double force : {1.5, 3.2, 3.7, 4.2, 4.3}) {
    EXPECT_RELATIVE(history.at("plate", force), -strain(force), 2e-4);
    double sum = 0;
    for (const auto& [name, yield] : bars) {
      EXPECT_NEAR(history.at(name, force), -std::min(yield, modulus * strain(force)), 1e-4) << name << force;
      sum += history.at(name, force);
    }
    EXPECT_NEAR(sum, -force, 1e-6);
  }
}

}  // namespace
}  // namespace plastic_bars_tests
}  // namespace creepcontact
