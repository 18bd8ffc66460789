/// linear_solver.method: which solver of the stiffness a run takes.

#include "../../../src/run/preparation.hpp"
#include "creepcontact/base/error.hpp"
#include "support/run/dense_solvers.hpp"
#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace {

class StiffnessMethod : public testing::Test {
 protected:
  /// Error bound of the solver that is made.
  double error_bound(const std::string& method, bool enough_memory, bool has_multigrid,
                     const std::vector<std::string>& more = {}) {
    std::vector<std::string> overrides = more;
    overrides.push_back("linear_solver.method=" + method);
    const config::Config config = blocks.config(pressure_probe, overrides);
    Model model = build_model(config);
    if (!enough_memory) model.solver.stiffness_solver = without_memory;
    Processes processes;
    if (has_multigrid) processes.multigrid = inexact_solvers;
    Stopwatch watch;
    return make_solver(config, model, model.assembly, processes, watch).interface().error_bound();
  }
  const Case blocks;
};

TEST_F(StiffnessMethod, AutoTakesFactorsIfThereIsMemory) {
  EXPECT_EQ(error_bound("auto", true, true), 0);
  EXPECT_GT(error_bound("auto", false, true), 0);
  EXPECT_EQ(error_bound("direct", true, true), 0);
  EXPECT_GT(error_bound("multigrid", true, true), 0);
}

TEST_F(StiffnessMethod, WhatCannotBeIsSaid) {
  const auto message = [&](const std::string& method, bool enough_memory, bool has_multigrid) {
    return message_of<Error>([&] { error_bound(method, enough_memory, has_multigrid); });
  };
  EXPECT_TRUE(says(message("multigrid", true, false), {"linear_solver.method = \"multigrid\"", "creepcontact-mpi"}));
  for (const auto& [method, has_multigrid] : {std::pair("direct", true), std::pair("auto", false)})
    EXPECT_TRUE(says(message(method, false, has_multigrid), {"memory"})) << method;
}

/// Where contact depends on its path, and is solved without an iteration around it, solves must be exact enough alone.
TEST_F(StiffnessMethod, SolvesAreAsExactAsTheTimeStepsWherePathsMatter) {
  const double usual = error_bound("multigrid", true, true);
  EXPECT_GT(usual, 0.01);
  EXPECT_LE(error_bound("multigrid", true, true, {"contacts.0.friction=0.3", "time.tolerance=1e-3"}), 1e-4);
  EXPECT_LE(error_bound("multigrid", true, true, {"contacts.0.friction=0.3", "time.tolerance=1e-5"}), 1.01e-6);
}

}  // namespace
}  // namespace creepcontact::run::test
