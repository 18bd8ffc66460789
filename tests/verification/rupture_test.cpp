// The end of life: damage that ruptures, life fractions, Arrhenius temperature dependence.

#include <fmt/format.h>

#include <cmath>

#include "verification/cube.hpp"

namespace creepcontact {
namespace {

using namespace test;

/// Rate = A (q/(1-w))^n, dw/dt = B q^r/(1-w)^phi; r = phi = 6, rupture at 100 MPa after 1000 h.
constexpr double A = 1e-15, n = 5, r = 6, stress = 100, rupture_time = 1000;
const double B = 1 / ((r + 1) * std::pow(stress, r) * rupture_time);
std::string kachanov(const std::string& more = "") {
  return creep_law_table("kachanov_rabotnov",
                         "A = 1e-15\nn = 5\nr = 6\nphi = 6\nB = " + fmt::format("{}", B) + "\n" + more);
}
double damage(double t) {
  return 1 - std::pow(1 - t / rupture_time, 1 / (r + 1));
}
double strain(double t) {
  const double p = 1 - n / (r + 1);
  return A * std::pow(stress, n) * rupture_time / p * (1 - std::pow(1 - t / rupture_time, p));
}

TEST(Rupture, UniaxialDamageEndsAtTheClosedFormsTime) {
  const Outcome outcome = run_cube(kachanov(), pulled("100"), "end = 5000\noutput = [100, 500, 900, 990, 2000]\n");
  EXPECT_EQ(outcome.summary.text("status"), "ruptured");
  EXPECT_RELATIVE(outcome.summary.number("time_reached"), rupture_time, 1e-5);
  for (const double t : {100.0, 500.0, 900.0, 990.0}) {
    EXPECT_NEAR(outcome.history.at("damage", t), damage(t), 1e-4);
    EXPECT_RELATIVE(outcome.history.at("cxx", t), strain(t), 1e-3);
  }
  const double end = outcome.history.times().back();
  EXPECT_RELATIVE(end, outcome.summary.number("time_reached"), 1e-9);
  EXPECT_GE(outcome.history.at("damage", end), 0.9);
}

/// The strain of the damaging material grows faster and faster, which is not a sign that the stress relaxes.
TEST(Rupture, IsFoundWhereCreepIsFast) {
  const std::string law = creep_law_table("kachanov_rabotnov", "A = 1e-14\nn = 5\nB = 4e-12\nr = 5\nphi = 4\n");
  const Outcome outcome = run_cube(law, pulled("100"), "end = 10\noutput = [10]\n");
  EXPECT_RELATIVE(outcome.summary.number("time_reached"), 5.0, 1e-6);
}

TEST(Rupture, EveryIntegratorFindsIt) {
  for (const char* integrator : {"cvode_bdf", "cvode_adams", "arkode_erk", "arkode_dirk"}) {
    const Outcome outcome = run_cube(kachanov(), pulled("100"),
                                     "end = 5000\noutput = [5000]\nintegrator = \"" + std::string(integrator) + "\"\n");
    EXPECT_RELATIVE(outcome.summary.number("time_reached"), rupture_time, 1e-4) << integrator;
  }
}

/// The wall of a pressurised sphere, sigma_1 = sigma_2 = q: omega_m = 32^(1 + 0.33) + 3 n, with n = 8.
TEST(Rupture, OfAnOmegaMaterialUnderBiaxialTension) {
  const std::string law = creep_law_table("omega",
                                          "rate0 = \"1e-20*q^8\"\nomega = 40\nmin_stress = 1\n"
                                          "multiaxial = \"api_579\"\nalpha_omega = 3\n");
  const Outcome outcome = run_cube(law, pulled("100") + "\n[[loads]]\non = \"y1\"\ntraction = [0, 100, 0]\n",
                                   "end = 300\noutput = [20, 50, 79]\n");
  const double omega = std::pow(32, 1.33) + 3 * 8, rupture = 1 / (omega * 1e-20 * std::pow(100, 8));
  EXPECT_EQ(outcome.summary.text("status"), "ruptured");
  for (const double t : {20.0, 50.0, 79.0}) EXPECT_NEAR(outcome.history.at("damage", t), t / rupture, 2e-4);
  // In the last half percent of the life rounding differences between the points of the element grow: it localises.
  EXPECT_RELATIVE(outcome.summary.number("time_reached"), rupture, 1e-2);
  EXPECT_RELATIVE(outcome.history.at("cxx", 50), -0.5 * std::log(1 - 50 / rupture) / omega, 1e-3);
}

TEST(Rupture, DamageByTheLargestPrincipalStressSparesCompression) {
  const Outcome outcome = run_cube(kachanov("alpha = 1"), pulled("-100"), "end = 2000\noutput = [2000]\n");
  EXPECT_EQ(outcome.summary.text("status"), "completed");
  EXPECT_EQ(outcome.history.at("damage", 2000), 0.0);
  EXPECT_RELATIVE(outcome.history.at("cxx", 2000), -A * std::pow(stress, n) * 2000, 1e-6);
}

TEST(Life, FractionsOfTimeAddOverSteps) {
  const Outcome outcome = run_cube(
      "[materials.steel.rupture]\nrupture_time = \"1e12/q^4\"\n" + creep_law_table("norton", "A = 1e-20\nn = 5"),
      pulled("{ t = [0, 100, 100], values = [100, 100, 200] }"), "end = 300\noutput = [50, 100, 300]\n");
  EXPECT_RELATIVE(outcome.history.at("life", 50), 50 * 1e8 / 1e12, 1e-5);
  EXPECT_RELATIVE(outcome.history.at("life", 300), 100 * 1e8 / 1e12 + 200 * 16e8 / 1e12, 1e-5);
  EXPECT_TRUE(outcome.summary.has("life_fraction"));
}

/// An elastic material may have rupture data too.
TEST(Life, LarsonMillerParameterGivesTheRuptureTime) {
  const Outcome outcome = run_cube(
      "reference_temperature = 20\n[materials.steel.rupture]\nlarson_miller_constant = 20\nstress = [50, 100, 200]\n"
      "parameter = [23000, 21000, 19000]\n",
      pulled("100") + "\n[temperature]\nvalue = 600\n", "end = 1000\noutput = [1000]\n");
  const double hours = std::pow(10.0, 21000 / 873.15 - 20);
  EXPECT_RELATIVE(outcome.history.at("life", 1000), 1000 / hours, 1e-6);
}

TEST(Temperature, ArrheniusFactorOfNorton) {
  for (const double T : {500.0, 600.0}) {
    const Outcome outcome =
        run_cube(creep_law_table("norton", "A = 1e-3\nn = 5\nactivation_energy = 400e3"),
                 pulled("100") + fmt::format("\n[temperature]\nvalue = {}\n", T), "end = 10\noutput = [10]\n");
    const double rate = 1e-3 * 1e10 * std::exp(-400e3 / (8.314462618 * (T + 273.15)));
    EXPECT_RELATIVE(outcome.history.at("cxx", 10), 10 * rate, 1e-6);
  }
}

}  // namespace
}  // namespace creepcontact
