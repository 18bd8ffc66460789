/// Contact that grows by creep under a constant force: contact_area against exact solutions and by refinement.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "support/says.hpp"
#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/half_space.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace {

using namespace test;

constexpr double area_bound = 0.03;

class GrowingContact : public testing::TestWithParam<const char*> {};

/// The example: a steel punch on a viscoelastic block. Exact for a rigid sphere of radius R on an incompressible half
/// space of shear compliance J: a^3 = 3 F R J(t)/16 (E. H. Lee and J. R. M. Radok, J. Appl. Mech. 27, 1960).
void expect_area_of_example(const std::vector<std::string>& changes) {
  const CaseDirectory directory("");
  config::Config config = config::read(CREEPCONTACT_CONFIGS "/viscoelastic_indenter.toml", run::vocabulary(), changes);
  config.output.fields = false;
  const auto results = directory.path() / "results";
  ASSERT_EQ(run::run(config, {.output = results.string()}).exit_status, 0);
  const Table history(results / "history.csv");
  for (const double t : history.times()) {
    const double compliance = 0.21834 + 0.77151 * (1 - std::exp(-t / 161.326)) + 0.84837 * (1 - std::exp(-t / 17288));
    const double radius = std::cbrt(3.0 * 10 * compliance / 16);
    EXPECT_RELATIVE(history.at("area", t), std::numbers::pi * radius * radius / 36, area_bound) << "t = " << t;
  }
}

TEST_P(GrowingContact, SphereOnViscoelasticBlock) {
  const std::string slave = std::string(GetParam()) == "upper" ? "punch_end" : "block_top";
  expect_area_of_example({"contacts.0.slave=" + slave});
}

/// Its gaps are those of the elements of the block, which are larger.
TEST(GrowingContactSlave, StiffAndFineSideGivesTheAreaToo) {
  expect_area_of_example({"contacts.0.slave=punch_end", "mesh.parameters.n_punch=16"});
}

/// Half of a rigid cylinder of radius 10 on a block, a slice of one element; a given gap between two blocks.
/// @param fine  elements of the lower block over 2.4. @param ratio  of the upper block's to them
Outcome press_cylinder(const std::string& slave, const std::string& creep, double end, int fine, double ratio = 0.75) {
  const double extent = 30, width = 2.4 / fine, force = 0.72;  // per length
  const HalfSpace lower{"lower", 0, -1, 2.4, fine, extent, fine / 2 + 4, fine / 2 + 6, width};
  const HalfSpace upper{"upper",      0,    1, 2.4, static_cast<int>(std::lround(fine * ratio)), extent, fine / 2 + 2,
                        fine / 2 + 4, width};
  std::string toml = "[mesh]\nfile = \"case.geo\"\norder = 2\n" + body("lower", 13.7295, 0.4988) + creep +
                     body("upper", 2.1e5, 0.3) + support("lower_far", "z");
  for (const std::string name : {"lower", "upper"})
    toml += support(name + "_x0", "x") + support(name + "_y0", "y") + support(name + "_back", "y");
  toml += fmt::format("[[loads]]\non = \"upper_far\"\npressure = {}\n", force / (2 * extent)) +
          contact_table("lower_patch", "upper_patch", "slave = \"" + slave + "_patch\"\ngap = \"x*x/20\"") +
          fmt::format("[time]\nend = {}\noutput = {{ first = {}, count = 9, spacing = \"log\" }}\n", end, end / 100) +
          probe("area", "contact_area", "on = \"lower_patch\"");
  return run_case(toml, "SetFactory(\"OpenCASCADE\");\n" + half_space_geo(lower) + half_space_geo(upper));
}

/// Seven to nineteen elements across. a^2 = F R J(t)/pi with J = 1/G + 3 t/viscosity.
TEST_P(GrowingContact, CylinderOnMaxwellBlock) {
  const double viscosity = 4119;
  const std::string maxwell = fmt::format("[[materials.lower.creep]]\nlaw = \"maxwell\"\nviscosity = {}\n", viscosity);
  for (const double ratio : {0.75, 4.0 / 3}) {
    const Outcome outcome = press_cylinder(GetParam(), maxwell, 700, 12, ratio);
    for (const double t : outcome.history.times()) {
      const double radius = std::sqrt(0.72 * 10 / std::numbers::pi * (3 / 13.7295 + 3 * t / viscosity));
      EXPECT_RELATIVE(outcome.history.at("area", t), radius * 0.2, area_bound) << "ratio " << ratio << " t = " << t;
    }
  }
}

/// Power-law creep: the same force on a mesh with three times as many elements.
TEST_P(GrowingContact, CylinderOnCreepingBlock) {
  const std::string norton = "[[materials.lower.creep]]\nlaw = \"norton\"\nA = 1e-3\nn = 3\n";
  const Outcome coarse = press_cylinder(GetParam(), norton, 5e3, 12), fine = press_cylinder("lower", norton, 5e3, 36);
  for (const double t : coarse.history.times())
    EXPECT_RELATIVE(coarse.history.at("area", t) / 0.2, fine.history.at("area", t) / (2.4 / 36), area_bound)
        << "t = " << t;
}

/// Three elements across are warned of, seven are not.
TEST(NarrowContact, IsWarnedOf) {
  for (const auto& [fine, wide] : {std::pair(4, false), std::pair(12, true)}) {
    testing::internal::CaptureStderr();
    press_cylinder("lower", "", 1, fine);
    const std::string warnings = testing::internal::GetCapturedStderr();
    EXPECT_EQ(warnings.find("3 elements") != std::string::npos, !wide) << warnings;
    EXPECT_EQ(warnings.find("warning: ") == std::string::npos, wide) << warnings;
  }
}

INSTANTIATE_TEST_SUITE_P(Slave, GrowingContact, testing::Values("lower", "upper"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace creepcontact
