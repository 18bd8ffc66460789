/// Generalised plane strain of two bodies of unlike expansion, each with an axial strain of its own or both with one.

#include <fmt/format.h>

#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace axial_strain_tests {
namespace {

using test::Outcome;
using test::Region;

/// One on top of the other; they may slide on each other and along z.
const std::vector<Region> plates{{"lower", {0, 2, 4}, {-1, 0, 3}}, {"upper", {0, 2, 5}, {0, 1, 3}}};
constexpr double area = 2, modulus = 1e5, alpha_lower = 1e-5, alpha_upper = 2e-5, rise = 100;

std::string material(const std::string& name, double alpha, const std::string& creep = "") {
  return fmt::format(
      "[bodies.{0}]\nregion = \"{0}\"\nmaterial = \"{0}\"\n[materials.{0}]\nyoung_modulus = {1}\npoisson_ratio = 0.3\n"
      "thermal_expansion = {2}\nreference_temperature = 0\n{3}",
      name, modulus, alpha, creep);
}

Outcome run_plates(const std::string& more, const std::string& creep = "",
                   const std::vector<std::string>& overrides = {}) {
  return test::run_case(
      test::section_of("generalized_plane_strain") + material("lower", alpha_lower, creep) +
          material("upper", alpha_upper, creep) + test::support("lower_y0", "y") + test::support("lower_x0", "x") +
          test::support("upper_x0", "x") + test::contact_table("lower_y1", "upper_y0") +
          "[[loads]]\non = \"upper_y1\"\npressure = 3\n" + fmt::format("[temperature]\nvalue = {}\n", rise) + more +
          test::probe("strain_lower", "axial_strain", "body = \"lower\"") +
          test::probe("strain_upper", "axial_strain", "body = \"upper\"") +
          test::probe("force_lower", "axial_force", "body = \"lower\"") +
          test::probe("force_upper", "axial_force", "body = \"upper\"") +
          test::probe("zz", "stress_zz", "body = \"upper\"\nreduce = \"max\""),
      test::regions_geo(plates), overrides);
}

constexpr double sideways = 0.3 * 3 / modulus;  // of the pressure, by Poisson's ratio
const std::string remark = "generalised plane strain: ";

bool has_remark(const Outcome& outcome) {
  for (const std::string& warning : outcome.summary.texts("warnings"))
    if (warning.starts_with(remark)) return true;
  return false;
}

TEST(AxialStrainPerBody, UnlikeExpansionMakesNoForce) {
  const Outcome outcome = run_plates("[generalized_plane_strain]\nper_body = true\n[time]\nend = 1\n");
  EXPECT_RELATIVE(outcome.history.at("strain_lower", 0), alpha_lower * rise + sideways, 1e-9);
  EXPECT_RELATIVE(outcome.history.at("strain_upper", 0), alpha_upper * rise + sideways, 1e-9);
  for (const char* probe : {"force_lower", "force_upper", "zz"}) EXPECT_NEAR(outcome.history.at(probe, 0), 0, 1e-7);
  EXPECT_FALSE(has_remark(outcome));
}

TEST(AxialStrainPerBody, TogetherTheyPullEachOtherAndTheRunSaysSo) {
  const Outcome outcome = run_plates("[time]\nend = 1\n");
  const double mean = (alpha_lower + alpha_upper) / 2 * rise + sideways;
  EXPECT_RELATIVE(outcome.history.at("strain_lower", 0), mean, 1e-6);
  EXPECT_RELATIVE(outcome.history.at("force_lower", 0), modulus * area * (alpha_upper - alpha_lower) / 2 * rise, 1e-6);
  EXPECT_TRUE(has_remark(outcome));
}

/// What keeps up a given axial strain acts along z on the whole section, at no place of the plane.
TEST(AxialStrain, NoPartOfItsForceActsBeyondACut) {
  const auto cut = [](const char* name, const char* quantity, const char* normal) {
    return test::probe(name, quantity,
                       fmt::format("body = \"upper\"\nsection = {{ origin = [1, 0, 0], normal = {} }}", normal));
  };
  const Outcome outcome =
      run_plates("[generalized_plane_strain]\nstrain = 1e-3\n[time]\nend = 1\n" +
                 cut("right", "section_force_z", "[1, 0, 0]") + cut("left", "section_force_z", "[-1, 0, 0]"));
  EXPECT_GT(std::abs(outcome.history.at("zz", 0)), 10);
  EXPECT_NEAR(outcome.history.at("right", 0), 0, 1e-9);
  EXPECT_NEAR(outcome.history.at("left", 0), 0, 1e-9);
}

TEST(AxialStrainPerBody, TiedBodiesHaveOneStrainWithoutARemark) {
  EXPECT_FALSE(has_remark(run_plates("[time]\nend = 1\n", "", {"contacts.0.type=tied"})));
}

TEST(AxialStrainPerBody, ForcesAreThoseOfEachBody) {
  const std::string creep = "creep = [{ law = \"norton\", A = 1e-6, n = 1 }]\n";
  const Outcome outcome =
      run_plates("[generalized_plane_strain]\nper_body = true\n[time]\nend = 3\noutput = [1]\ntolerance = 1e-6\n",
                 creep, {"bodies.upper.axial_force=10*min(t, 1)"});
  for (const double t : {0.0, 1.0, 3.0}) {
    EXPECT_NEAR(outcome.history.at("force_lower", t), 0, 1e-7);
    EXPECT_NEAR(outcome.history.at("force_upper", t), 10 * std::min(t, 1.0), 1e-7);
  }
  // Norton's law with n = 1 is linear: axial creep of s_z - s_y / 2, with s_y = -3.
  const double integral = 0.5 + 2;  // of min(t, 1)
  EXPECT_RELATIVE(outcome.history.at("strain_upper", 3),
                  alpha_upper * rise + sideways + 10 / area / modulus + 1e-6 * (10 / area * integral + 1.5 * 3), 1e-6);
}

TEST(AxialStrainPerBody, NoRemarkWithoutTemperatureOrWithLikeExpansion) {
  EXPECT_FALSE(has_remark(test::run_case(
      test::section_of("generalized_plane_strain") + material("lower", alpha_lower) + material("upper", alpha_lower) +
          test::support("lower_y0", "y") + test::support("lower_x0", "x") + test::support("upper_x0", "x") +
          test::contact_table("lower_y1", "upper_y0") + "[[loads]]\non = \"upper_y1\"\npressure = 3\n" +
          "[temperature]\nvalue = 100\n[time]\nend = 1\n",
      test::regions_geo(plates))));
}

}  // namespace
}  // namespace axial_strain_tests
}  // namespace creepcontact
