/// The implicit integrators with a direct solver of their Newton systems.

#include <algorithm>

#include "creepcontact/base/error.hpp"
#include "every_integrator.hpp"

namespace creepcontact::ode {
namespace {

constexpr double tau = 1 / (ParallelBars::E * 1e-14 * 1e8);  ///< relaxation time of the slowest of the bars [h]

class Tangent : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<Integrator> make(System& system, double tolerance, double end_time = 0) const {
    return make_integrator(GetParam(), system,
                           {.tolerance = tolerance, .linear_solver = LinearSolver::tangent, .end_time = end_time});
  }
};

TEST_P(Tangent, AsksForFactorsAtTheLastEvaluationAndForNoProducts) {
  ParallelBars bars(20, 100);
  auto integrator = make(bars, 1e-4);
  integrate(*integrator, 0, Values(20), {10 * tau});
  EXPECT_EQ(bars.calls_elsewhere, 0);
  EXPECT_EQ(bars.counters().jacobian_products, 0);
  EXPECT_EQ(bars.preparations, 0);
  EXPECT_GT(bars.tangent_solves, 0);
  for (const double gamma : bars.gammas) EXPECT_GT(gamma, 0);
}

TEST_P(Tangent, FactorsServeManySolves) {
  ParallelBars bars(20, 100);
  auto integrator = make(bars, 1e-4, 10 * tau);
  integrate(*integrator, 0, Values(20), {10 * tau});
  EXPECT_GT(bars.factorizations, 2);
  EXPECT_LT(3 * bars.factorizations, bars.tangent_solves);
}

TEST_P(Tangent, ReachesTheSteadyStateOfGradedBars) {
  for (const double tolerance : {1e-3, 1e-4, 1e-5}) {
    ParallelBars bars(30, 1e4);
    auto integrator = make(bars, tolerance, 1e3 * tau);
    integrate(*integrator, 0, Values(30), {1e3 * tau});
    const Values stress = bars.stress(integrator->state());
    for (std::size_t i = 0; i < stress.size(); ++i)
      EXPECT_NEAR(stress[i], bars.steady_stress(i), 2 * tolerance * ParallelBars::mean_stress) << i;
    // Stages have no history to predict them from after a restart point.
    const std::int64_t most = GetParam() == "arkode_dirk" ? integrator->counters().steps / 20 : 0;
    EXPECT_LE(integrator->counters().convergence_failures, most);
    EXPECT_LT(bars.factorizations, integrator->counters().steps);
    RecordProperty("factorizations", static_cast<int>(bars.factorizations));
    RecordProperty("tangent_solves", bars.tangent_solves);
  }
}

TEST_P(Tangent, FollowsARelaxationWithinItsTolerance) {
  const Values times{0.1, 1, 10, 100, 1000};
  for (const double tolerance : {1e-4, 1e-5, 1e-6, 1e-7}) {
    RelaxingBar bar;
    auto integrator = make(bar, tolerance);
    const auto states = integrate(*integrator, 0, Values(1), times);
    for (std::size_t i = 0; i < times.size(); ++i)
      EXPECT_NEAR(RelaxingBar::stress(states[i][0]), RelaxingBar::exact_stress(times[i]),
                  3 * tolerance * RelaxingBar::initial_stress)
          << times[i];
  }
}

TEST_P(Tangent, ASingularMatrixIsMendedByASmallerStep) {
  RelaxingBar bar;
  const auto run = [&] {
    auto integrator = make(bar, 1e-5);
    integrate(*integrator, 0, Values(1), {100.0});
    return integrator->counters().convergence_failures;
  };
  ASSERT_EQ(run(), 0);
  const double largest = *std::max_element(bar.gammas.begin(), bar.gammas.end());
  bar.tangent_interceptor = [&](double gamma) {
    if (gamma > 0.2 * largest) throw RecoverableError("singular");
  };
  EXPECT_GT(run(), 0);
}

TEST_P(Tangent, OtherErrorsPassThrough) {
  RelaxingBar bar;
  bar.tangent_interceptor = [](double) { throw ModelError("no such matrix"); };
  auto integrator = make(bar, 1e-5);
  integrator->initialize(0, Values(1));
  EXPECT_THROW(integrator->step(1), ModelError);
}

TEST_P(Tangent, GoesOnFromRestartPointsToTheLastBitWithoutTheOldFactors) {
  const double end = 10 * tau;
  ParallelBars bars(6, 100);
  auto whole = make(bars, 1e-6, end);
  whole->initialize(0, Values(6));
  std::vector<RestartPoint> points;
  while (whole->time() < end) {
    whole->step(end);
    if (whole->at_restart_point()) points.push_back(whole->save());
  }
  if (!whole->restores_exactly()) GTEST_SKIP() << "loses its history";
  ASSERT_GT(points.size(), 2U);
  for (const RestartPoint& point : points) {
    ParallelBars fresh(6, 100);
    auto resumed = make(fresh, 1e-6, end);
    resumed->restore(point);
    while (resumed->time() < end) resumed->step(end);
    EXPECT_TRUE(std::ranges::equal(resumed->state(), whole->state())) << point.time;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Tangent, testing::Values("cvode_bdf", "arkode_dirk"), test_name);

}  // namespace
}  // namespace creepcontact::ode
