/// Whole runs of sections: every integrator in every analysis, resuming, floating bodies, temperature-dependent moduli.

#include <fmt/format.h>

#include <fstream>
#include <numbers>

#include "creepcontact/base/error.hpp"
#include "creepcontact/model/model.hpp"
#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace section_runs {
namespace {

using test::Outcome;
using test::Region;

const std::vector<Region> blocks{{"foot", {1, 2.5, 6}, {-1, 0, 4}}, {"block", {1, 2, 5}, {0, 1, 4}}};

/// A block pressed on a foot, both creeping; the upper end is held in y, and part of the contact opens.
std::string pressed_block(const std::string& analysis) {
  std::string toml = test::section_of(analysis) + test::body("block", 1, 0.3, 50, 3) +
                     test::body("foot", 2, 0.3, 20, 3) + test::support("foot_y0", "y") +
                     test::support("block_y1", "y", "-0.05") +
                     test::contact_table("block_y0", "foot_y1", "gap = \"0.02*(x - 1)^2\"");
  if (analysis != "axisymmetric") toml += test::support("foot_x0", "x") + test::support("block_x0", "x");
  return toml + test::probe("force", "contact_force_y", "on = \"block_y0\"") +
         test::probe("q", "von_mises", "body = \"foot\"\nreduce = \"mean\"");
}

class SectionRuns : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Analyses, SectionRuns,
                         testing::Values("axisymmetric", "plane_strain", "plane_stress", "generalized_plane_strain"),
                         [](const auto& of) { return of.param; });

TEST_P(SectionRuns, IntegratorsAgree) {
  const auto run = [&](const std::string& time) {
    return test::run_case(pressed_block(GetParam()) + "[time]\nend = 10\noutput = [1]\n" + time,
                          test::regions_geo(blocks))
        .history;
  };
  const test::Table exact = run("tolerance = 1e-7\nintegrator = \"cvode_adams\"\n");
  EXPECT_LT(exact.at("force", 10), 0.9 * exact.at("force", 0));
  for (const char* time : {"integrator = \"cvode_adams\"\n", "integrator = \"cvode_bdf\"\n",
                           "integrator = \"cvode_bdf\"\nlinear_solver = \"tangent\"\n", "integrator = \"arkode_erk\"\n",
                           "integrator = \"arkode_dirk\"\n",
                           "integrator = \"beta_euler\"\nbeta = 0.5\nstep = \"adaptive\"\ninner = \"newton\"\n"}) {
    const test::Table found = run(time);
    for (const double t : {1.0, 10.0})
      for (const char* probe : {"force", "q"}) EXPECT_RELATIVE(found.at(probe, t), exact.at(probe, t), 1e-3) << time;
  }
}

TEST_P(SectionRuns, ContactSolversAgree) {
  const auto run = [&](const std::string& solver) {
    return test::run_case(pressed_block(GetParam()) + "[time]\nend = 1\ntolerance = 1e-6\n" + solver,
                          test::regions_geo(blocks))
        .history.at("force", 1);
  };
  const double expected = run("[contact_solver]\nmethod = \"active_set\"\n");
  for (const char* solver :
       {"method = \"schwarz\"\n", "method = \"schwarz\"\nacceleration = \"aitken\"\n",
        "method = \"schwarz\"\nacceleration = \"anderson\"\n", "method = \"active_set\"\ndense_limit_mb = 0\n"})
    EXPECT_RELATIVE(run(fmt::format("[contact_solver]\n{}", solver)), expected, 1e-6) << solver;
}

TEST_P(SectionRuns, ResumeWhereTheyWereInterrupted) {
  const test::CaseDirectory directory(test::regions_geo(blocks));
  const auto config = [&](double end) {
    config::Config read =
        directory.config(pressed_block(GetParam()) + fmt::format("[time]\nend = {}\noutput = [1, 2]\n", end), {});
    read.output.fields = false;
    return read;
  };
  const auto parts = (directory.path() / "parts").string(), whole = (directory.path() / "whole").string();
  ASSERT_EQ(run::run(config(2), {.output = parts}).exit_status, 0);
  ASSERT_EQ(run::run(config(10), {.output = parts, .resume = true}).exit_status, 0);
  ASSERT_EQ(run::run(config(10), {.output = whole}).exit_status, 0);
  const test::Table resumed(std::filesystem::path(parts) / "history.csv"),
      at_once(std::filesystem::path(whole) / "history.csv");
  EXPECT_RELATIVE(resumed.at("force", 10), at_once.at("force", 10), 1e-4);
}

// A block that two walls alone hold: two translations and a rotation; it closes both gaps under the pressures.
TEST(FloatingSection, BlockInACornerClosesItsGaps) {
  for (const char* method : {"schwarz", "active_set"}) {
    const Outcome outcome = test::run_case(
        test::section_of("plane_strain") + test::body("block", 100, 0.3) + test::body("floor", 100, 0.3) +
            test::body("wall", 100, 0.3) + test::support("floor_y0", "y") + test::support("floor_x0", "x") +
            test::support("wall_x0", "x") + test::support("wall_y0", "y") +
            test::contact_table("block_y0", "floor_y1", "gap = 0.02") +
            test::contact_table("block_x0", "wall_x1", "gap = 0.01") +
            "[[loads]]\non = \"block_y1\"\npressure = 3\n[[loads]]\non = \"block_x1\"\npressure = 2\n[time]\nend = "
            "1\n" +
            fmt::format("[contact_solver]\nmethod = \"{}\"\n", method) +
            test::probe("yy", "stress_yy", "body = \"block\"\nreduce = \"min\"") +
            test::probe("xx", "stress_xx", "body = \"block\"\nreduce = \"max\"") +
            test::probe("uy", "displacement_y", "on = \"block_y0\"") +
            test::probe("ux", "displacement_x", "on = \"block_x0\""),
        test::regions_geo(
            {{"block", {0, 1, 4}, {0, 1, 4}}, {"floor", {0, 1, 3}, {-1, 0, 3}}, {"wall", {-1, 0, 3}, {0, 1, 5}}}));
    EXPECT_RELATIVE(outcome.history.at("yy", 0), -3, 1e-8);
    EXPECT_RELATIVE(outcome.history.at("xx", 0), -2, 1e-8);
    // The gaps, and what the floor and the wall give way: plane strain, free sides.
    const double per_pressure = (1 - 0.3 * 0.3) / 100;
    EXPECT_RELATIVE(outcome.history.at("uy", 0), -0.02 - 3 * per_pressure, 1e-6);
    EXPECT_RELATIVE(outcome.history.at("ux", 0), -0.01 - 2 * per_pressure, 1e-6);
  }
}

// A ring that lies on another one: one translation, which its weight and the contact hold.
TEST(FloatingSection, RingOnARingUnderItsWeight) {
  const Outcome outcome =
      test::run_case(test::section_of("axisymmetric") + test::body("lower", 100, 0.3) + test::body("upper", 100, 0.3) +
                         test::support("lower_y0", "y") + test::contact_table("lower_y1", "upper_y0", "gap = 0.05") +
                         "[[loads]]\nbody = \"upper\"\nbody_force = [0, -2, 0]\n[time]\nend = 1\n" +
                         test::probe("force", "contact_force_y", "on = \"upper_y0\"") +
                         test::probe("gap", "gap", "on = \"upper_y0\"\nreduce = \"max\""),
                     test::regions_geo({{"lower", {1, 2, 4}, {0, 1, 3}}, {"upper", {1, 2, 5}, {1, 2, 3}}}));
  EXPECT_RELATIVE(outcome.history.at("force", 0), 2 * std::numbers::pi * 3, 1e-9);
  EXPECT_NEAR(outcome.history.at("gap", 0), 0, 1e-12);
}

// Moduli that follow a temperature in time: the stress of a held bar is E(T) times its strain.
TEST(HotSection, ModuliFollowTheTemperature) {
  for (const std::string analysis : {"plane_stress", "axisymmetric", "generalized_plane_strain"}) {
    const Outcome outcome = test::run_case(test::section_of(analysis) + R"toml(
          [bodies.bar]
          region = "bar"
          material = "steel"
          [materials.steel]
          young_modulus = "2e5 - 100*T"
          poisson_ratio = 0.3
          [temperature]
          value = "1000*t"
        )toml" + test::support("bar_y0", "y") + test::support("bar_y1", "y", "0.001") +
                                               "[time]\nend = 1\noutput = [0.5]\n" +
                                               (analysis == "axisymmetric" ? "" : test::support("bar_x0", "x")) +
                                               test::probe("yy", "stress_yy", "body = \"bar\""),
                                           test::regions_geo({{"bar", {1, 2, 3}, {0, 1, 4}}}));
    for (const double t : {0.0, 0.5, 1.0})
      EXPECT_RELATIVE(outcome.history.at("yy", t), (2e5 - 1e5 * t) * 1e-3, 1e-8) << analysis;
  }
}

// Points of a solid, or with y and z exchanged, are no temperatures of a section.
TEST(HotSection, TemperaturesOutsideThePlaneAreRefused) {
  const test::CaseDirectory directory(test::regions_geo({{"bar", {1, 2, 3}, {0, 1, 4}}}));
  const config::Config config =
      directory.config(test::section_of("axisymmetric") + test::body("bar", 1e5, 0.3) + test::support("bar_y0", "y") +
                           "[temperature]\nfile = \"T.csv\"\n[time]\nend = 1\n",
                       {});
  for (const char* z : {"0", "0.5"}) {
    std::ofstream(directory.path() / "T.csv") << "x,y,z,T\n1,0,0,20\n2,0,0,30\n1,1,0,20\n2,1," << z << ",30\n";
    if (std::string(z) == "0") {
      EXPECT_NO_THROW(model::build_model(config));
    } else {
      EXPECT_THROW(model::build_model(config), ModelError);
    }
  }
}

// The unit of length does not matter to the unknown axial strain.
TEST(AxialStrain, AnyUnitOfLength) {
  for (const double unit : {1e-1, 1.0, 1e5}) {
    const Outcome outcome = test::run_case(
        test::section_of("generalized_plane_strain") + test::body("lower", 100, 0.3) + test::body("upper", 100, 0.3) +
            test::support("lower_y0", "y") + test::support("lower_x0", "x") + test::support("upper_x0", "x") +
            test::contact_table("lower_y1", "upper_y0") +
            "[[loads]]\non = \"upper_y1\"\npressure = 3\n[time]\nend = 1\n" +
            test::probe("strain", "axial_strain", "body = \"upper\"") +
            test::probe("p", "contact_pressure", "on = \"upper_y0\"\nreduce = \"max\""),
        test::regions_geo({{"lower", {0, unit, 4}, {-unit, 0, 3}}, {"upper", {0, unit, 5}, {0, unit, 3}}}));
    EXPECT_RELATIVE(outcome.history.at("strain", 0), 0.3 * 3 / 100, 1e-9) << unit;
    EXPECT_RELATIVE(outcome.history.at("p", 0), 3, 1e-9) << unit;
  }
}

}  // namespace
}  // namespace section_runs
}  // namespace creepcontact
