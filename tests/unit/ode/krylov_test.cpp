/// What the Newton-Krylov integrators ask of System, and how much.

#include "every_integrator.hpp"

namespace creepcontact::ode {
namespace krylov_tests {
namespace {

using NewtonKrylov = EveryIntegrator;

std::int64_t cost(const System& system) {
  return system.counters().rate_evaluations + system.counters().jacobian_products;
}

constexpr double tau = 1 / (ParallelBars::E * 1e-14 * 1e8);  ///< relaxation time of the slowest of the bars [h]

TEST_P(NewtonKrylov, AsksForTheJacobianAtTheLastEvaluation) {
  ParallelBars bars(20, 100);
  auto integrator = make(bars, 1e-4);
  integrate(*integrator, 0, Values(20), {10 * tau});
  EXPECT_GT(bars.counters().jacobian_products, 0);
  EXPECT_GT(bars.preparations, 0);
  EXPECT_EQ(bars.calls_elsewhere, 0);
}

TEST_P(NewtonKrylov, ExactPreconditionerNeedsOneProductASolve) {
  // Without coupling the point-wise part is the whole Jacobian: gamma and the prepared point must be right for this.
  LinearSystem system({-1, -30, -1000}, true);
  auto integrator = make(system, 1e-5);
  integrate(*integrator, 0, Values{0, 0, 0}, {10.0});
  EXPECT_GT(system.counters().jacobian_products, 20);
  EXPECT_LE(system.counters().jacobian_products, system.counters().rate_evaluations);
  EXPECT_LT(system.preparations, system.counters().rate_evaluations / 2) << "prepared at new linearisations only";
  for (double gamma : system.gammas) EXPECT_GT(gamma, 0);
}

TEST_P(NewtonKrylov, ReachesTheSteadyStateOfGradedBars) {
  for (double tolerance : {1e-3, 1e-4, 1e-5}) {
    ParallelBars bars(30, 1e4);
    IntegratorOptions options = accurate_options(GetParam(), tolerance);
    options.end_time = 1e3 * tau;
    auto integrator = make_variant(GetParam(), bars, options);
    integrate(*integrator, 0, Values(30), {options.end_time});
    const Values stress = bars.stress(integrator->state());
    for (std::size_t i = 0; i < stress.size(); ++i)
      EXPECT_NEAR(stress[i], bars.steady_stress(i), 2 * tolerance * ParallelBars::mean_stress) << i;
    EXPECT_LE(integrator->counters().convergence_failures, integrator->counters().steps / 10);
  }
}

INSTANTIATE_TEST_SUITE_P(All, NewtonKrylov, testing::Values("cvode_bdf", "arkode_dirk"), test_name);

TEST(CvodeBdf, CostDoesNotGrowWithStiffnessOrTime) {
  // Explicit schemes need at least as many evaluations as relaxation times of the fastest bar.
  for (const auto& [grading, relaxation_times, most] :
       {std::tuple{1e2, 1e0, 240}, {1e2, 1e3, 260}, {1e4, 1e0, 390}, {1e4, 1e3, 400}}) {
    ParallelBars bars(50, grading);
    IntegratorOptions options = accurate_options("cvode_bdf", 1e-4);
    options.end_time = relaxation_times * tau;
    auto integrator = make_integrator("cvode_bdf", bars, options);
    integrate(*integrator, 0, Values(50), {options.end_time});
    EXPECT_LE(cost(bars), most) << "grading " << grading << ", " << relaxation_times << " relaxation times";
    RecordProperty("rates_and_products", static_cast<int>(cost(bars)));
  }
}

TEST(CvodeBdf, ErrorOfTheStressIsBoundedByTheToleranceNotByTheCreepStrain) {
  // Constant force: the creep strain grows without end, the stress must stay put.
  ParallelBars bars(10, 100);
  IntegratorOptions options = accurate_options("cvode_bdf", 1e-4);
  options.end_time = 1e4 * tau;
  auto integrator = make_integrator("cvode_bdf", bars, options);
  integrate(*integrator, 0, Values(10), {options.end_time});
  EXPECT_GT(integrator->state()[0], 1e3 * bars.scale()[0]);
  const Values stress = bars.stress(integrator->state());
  for (std::size_t i = 0; i < stress.size(); ++i) EXPECT_NEAR(stress[i], bars.steady_stress(i), 2e-2);
}

}  // namespace
}  // namespace krylov_tests
}  // namespace creepcontact::ode
