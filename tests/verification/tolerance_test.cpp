/// The tolerance means the relative error of the stress at the output times, whatever the model; and what a given
/// accuracy costs in elastic solves.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "verification/stress_runs.hpp"

namespace creepcontact::test {
namespace tolerance_tests {
namespace {

struct Case {
  std::string name, file;
  std::vector<std::string> overrides;  // coarse meshes: tolerances and costs do not depend on the mesh
  int max_solves;                      // for an error of 1e-3
};
void PrintTo(const Case& tested, std::ostream* out) {  // NOLINT(readability-identifier-naming): of GTest
  *out << tested.name;
}

std::vector<Case> cases() {
  return {
      {"ThickCylinder",
       "thick_cylinder.toml",
       {"materials.steel.creep.0.n=6", "materials.steel.creep.0.A=1e-16", "time.end=3"},
       200},
      {"PlateWithHole", "plate_with_hole.toml", {}, 250},
      {"ShrinkFit", "shrink_fit.toml", {"mesh.parameters.around_shaft=6", "mesh.parameters.around_disc=5"}, 120},
      {"BallOnBlock",
       "ball_on_block.toml",
       {"mesh.parameters.h=0.7", "time.end=10", "time.output={first=1e-2,count=10,spacing=\"log\"}"},
       250},
      {"BladeRoot",
       "blade_root.toml",
       {"mesh.parameters={n_blade=2,n_disc=2,n_blade_flank=3,n_disc_flank=2,n_width=1}", "time.end=1e4"},
       150},
  };
}

class Tolerance : public testing::TestWithParam<Case> {};

TEST_P(Tolerance, BoundsTheRelativeErrorOfTheStress) {
  StressRuns runs = StressRuns::of_file(GetParam().file, GetParam().overrides);
  const StressHistory reference = runs.run(1e-7, "cvode_bdf");
  for (const std::string integrator : {"auto", "cvode_bdf"}) {
    SCOPED_TRACE(integrator);
    auto enough = std::numeric_limits<std::int64_t>::max();  // solves of the cheapest run with an error below 1e-3
    for (const double tolerance : {1e-2, 3e-3, 1e-3, 1e-4, 1e-6}) {
      const StressHistory history = runs.run(tolerance, integrator);
      const StressError error = runs.error(history, reference);
      RecordProperty(
          fmt::format("{}_at_{:g}", integrator, tolerance),
          fmt::format("norm {:.2g}, maximum {:.2g} of the tolerance; {} solves, {} steps, {} rejected, {} failures",
                      error.norm / tolerance, error.maximum / tolerance, history.elastic_solves, history.steps.steps,
                      history.steps.rejected_steps, history.steps.convergence_failures));
      EXPECT_LT(error.norm, 3 * tolerance) << tolerance;
      EXPECT_LT(error.maximum, (integrator == "auto" ? 3 : 6) * tolerance) << tolerance;  // hot spots
      EXPECT_LE(history.steps.convergence_failures, history.steps.steps / 10) << tolerance;
      if (error.norm < 1e-3) enough = std::min(enough, history.elastic_solves);
    }
    if (integrator == "auto") {
      EXPECT_LE(enough, GetParam().max_solves);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Tolerance, testing::ValuesIn(cases()), [](const auto& of) { return of.param.name; });

/// A finer mesh takes as many solves: what limits the steps is how fast the stress changes.
TEST(ElasticSolves, DoNotDependOnTheMesh) {
  struct Meshes {
    std::string file;
    std::vector<std::string> coarse, fine;
  };
  for (const Meshes& meshes :
       {Meshes{"thick_cylinder.toml",
               {"mesh.parameters={n_wall=10,n_around=2}"},
               {"mesh.parameters={n_wall=20,n_around=4}"}},
        {"plate_with_hole.toml", {"mesh.parameters={n_around=4,n_out=6}"}, {"mesh.parameters={n_around=8,n_out=12}"}},
        {"ball_on_block.toml",
         {"mesh.parameters.h=0.6", "time.end=10", "time.output=[10]"},
         {"mesh.parameters.h=0.4", "time.end=10", "time.output=[10]"}}}) {
    const auto coarse =
        static_cast<double>(StressRuns::of_file(meshes.file, meshes.coarse).run(1e-3, "cvode_bdf").elastic_solves);
    const auto fine =
        static_cast<double>(StressRuns::of_file(meshes.file, meshes.fine).run(1e-3, "cvode_bdf").elastic_solves);
    EXPECT_NEAR(fine / coarse, 1, 0.2) << meshes.file << ": " << coarse << " and " << fine;
  }
}

}  // namespace
}  // namespace tolerance_tests
}  // namespace creepcontact::test
