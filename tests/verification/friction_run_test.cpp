/// Whole runs with friction and creep: every integrator, and resuming.

#include <fmt/format.h>

#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/interrupted.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace friction_runs {
namespace {

/// A block pressed on a foot, both creeping; its free end is pulled to and fro, and it slips from there.
std::string pulled_block(const std::string& time) {
  return test::section_of("plane_strain") + test::body("foot", 2, 0.3, 20, 3) + test::body("block", 1, 0.3, 50, 3) +
         test::support("foot_y0", "x") + test::support("foot_y0", "y") + test::support("block_x0", "x") +
         test::contact_table("block_y0", "foot_y1", "friction = 0.3") +
         "[[loads]]\non = \"block_y1\"\npressure = 0.05\n"
         "[[loads]]\non = \"block_x1\"\ntraction = [\"0.03*sin(0.6*t)\", 0, 0]\n"
         "[time]\nend = 8\noutput = [0.5, 1, 2, 4, 6]\n" +
         time + test::probe("slip", "slip", "on = \"block_y0\"\nreduce = \"max\"") +
         test::probe("end", "displacement_x", "on = \"block_x1\"") +
         test::probe("force", "contact_force_x", "on = \"block_y0\"") +
         test::probe("q", "von_mises", "body = \"foot\"\nreduce = \"mean\"");
}

std::string geo() {
  return test::regions_geo({{"foot", {0.5, 3.5, 10}, {-1, 0, 4}}, {"block", {1, 3, 8}, {0, 0.5, 3}}});
}

TEST(FrictionRuns, IntegratorsAgree) {
  const auto run = [&](const std::string& time) { return test::run_case(pulled_block(time), geo()); };
  const test::Outcome exact = run("tolerance = 1e-7\nintegrator = \"cvode_adams\"\n");
  EXPECT_GT(exact.history.at("slip", 8), 1.2 * exact.history.at("slip", 2)) << "it slips back and forth";
  EXPECT_GT(exact.history.at("slip", 2), 4 * exact.history.at("slip", 1));
  for (const char* time : {"integrator = \"auto\"\n", "integrator = \"cvode_adams\"\n", "integrator = \"cvode_bdf\"\n",
                           "integrator = \"cvode_bdf\"\nlinear_solver = \"tangent\"\n", "integrator = \"arkode_erk\"\n",
                           "integrator = \"arkode_dirk\"\n",
                           "integrator = \"beta_euler\"\nbeta = 0.5\nstep = \"adaptive\"\ninner = \"newton\"\n",
                           "integrator = \"beta_euler\"\nbeta = 0.5\nstep = 0.0625\n",
                           "integrator = \"beta_euler\"\nstep = \"adaptive\"\n",
                           "integrator = \"explicit_euler\"\nstep = \"adaptive\"\n"}) {
    const test::Outcome found = run(std::string("tolerance = 1e-5\n") + time);
    for (const char* probe : {"slip", "end", "force", "q"}) {
      double largest = 0;
      for (const double value : exact.history.column(probe)) largest = std::max(largest, std::abs(value));
      for (const double t : exact.history.times())
        EXPECT_NEAR(found.history.at(probe, t) / largest, exact.history.at(probe, t) / largest, 1e-3)
            << time << probe << " at " << t;
    }
  }
}

/// Interrupts a run as Ctrl-C does.
class FrictionResume : public testing::TestWithParam<std::string> {};

TEST_P(FrictionResume, RepeatsTheUninterruptedRun) {
  const test::CaseDirectory directory(geo());
  config::Config config = directory.config(pulled_block(GetParam()), {});
  config.output.fields = false;
  test::expect_same_when_resumed(config, directory.path(), {1.5, 5});
  const std::filesystem::path whole = directory.path() / "whole", parts = directory.path() / "parts";
  const test::SummaryFile resumed(parts / "summary.json"), at_once(whole / "summary.json");
  for (const char* key : {"dissipated_energy", "largest_slip"}) {
    const std::string name = std::string("contacts/block_y0~1foot_y1/") + key;
    EXPECT_GT(at_once.number(name), 0);
    EXPECT_EQ(resumed.number(name), at_once.number(name));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Integrators, FrictionResume,
    testing::Values("integrator = \"arkode_erk\"\n", "integrator = \"arkode_dirk\"\n",
                    "integrator = \"beta_euler\"\nbeta = 0.5\nstep = \"adaptive\"\ninner = \"newton\"\n",
                    "integrator = \"beta_euler\"\nbeta = 0.5\nstep = 0.25\n",
                    "integrator = \"explicit_euler\"\nstep = \"adaptive\"\n"),
    [](const auto& of) {
      std::string name;
      for (const char letter : of.param)
        if (std::isalnum(static_cast<unsigned char>(letter)) != 0) name += letter;
      return name;
    });

}  // namespace
}  // namespace friction_runs
}  // namespace creepcontact
