#include <algorithm>
#include <cmath>
#include <numbers>

#include "every_integrator.hpp"

namespace creepcontact::ode {
namespace {

using Limits = EveryIntegrator;

void run_to(Integrator& integrator, double limit) {
  while (integrator.time() < limit) {
    const double before = integrator.time();
    const StepReport report = integrator.step(limit);
    ASSERT_GT(report.time, before);
    ASSERT_LE(report.time, limit);
    ASSERT_NEAR(report.step, report.time - before, 1e-12 * (1 + report.time));
  }
  ASSERT_EQ(integrator.time(), limit);
}

TEST_P(Limits, EndsExactlyOnEachOfSeveral) {
  LinearSystem system({-1.0, -3.0});
  auto integrator = make(system, 1e-4);
  integrator->initialize(0, Values{1, 1});
  for (double limit : {0.1, 0.3, 1.0 / 3, 1.0, std::nextafter(1.0, 2.0), 1.0 + 1e-12, 1.0 + 1e-9, 1.1, 2.5}) {
    run_to(*integrator, limit);
    EXPECT_NEAR(integrator->state()[0], std::exp(-limit), 2e-3);
    EXPECT_NEAR(integrator->state()[1], std::exp(-3 * limit), 2e-3);
  }
}

TEST_P(Limits, AreNotLookedBeyond) {
  LinearSystem system({-1.0, -3.0});
  double limit = 0;
  system.interceptor = [&](double t, std::span<const double>) { EXPECT_LE(t, limit); };
  auto integrator = make(system, 1e-4);
  integrator->initialize(0, Values{1, 1});
  for (double next : {0.001, 0.1, 0.5, 3.0}) {
    limit = next;
    run_to(*integrator, limit);
  }
}

TEST_P(Limits, MayBeWhereTheStepWouldHaveEndedAnyway) {
  LinearSystem system({-1.0});
  auto free = make(system, 1e-4);
  free->initialize(0, Values{1});
  for (int k = 0; k < 6; ++k) {
    const double natural = free->step(10).time;
    auto limited = make(system, 1e-4);
    limited->initialize(0, Values{1});
    run_to(*limited, natural);
    const StepReport next = limited->step(10);
    EXPECT_GT(next.step, 1e-6) << "a sliver after the limit";
  }
}

TEST_P(Limits, MayMoveAndVanish) {
  LinearSystem system({-1.0});
  auto integrator = make(system, 1e-4);
  integrator->initialize(0, Values{1});
  integrator->step(5);
  integrator->step(3);
  integrator->step(std::numeric_limits<double>::infinity());
  integrator->step(1e200);
  // The limits that were given up must not stop it.
  while (integrator->time() < 6) integrator->step(std::numeric_limits<double>::infinity());
  EXPECT_NE(integrator->time(), 3);
  EXPECT_NE(integrator->time(), 5);
  run_to(*integrator, 7);
  EXPECT_NEAR(integrator->state()[0], std::exp(-7), 2e-3);
}

/// y' = 1, and a pulse that is short compared with the steps outside it.
class Pulse : public TestSystem {
 public:
  static constexpr double middle = 502, width = 0.3, height = 1e4;
  Pulse() : TestSystem(1, 1) {}

 protected:
  void f(double t, std::span<const double>, std::span<double> rate) const override {
    rate[0] = 1 + height * std::exp(-std::pow((t - middle) / width, 2));
  }
  void df(double, std::span<const double>, std::span<const double>, std::span<double> product) const override {
    product[0] = 0;
  }
  void local(double, std::span<const double>, std::span<double> diagonal) const override { diagonal[0] = 0; }
};

// As of one who knows of the pulse: each step is as short as the pulse needs it, and none says why.
TEST_P(Limits, ThatFollowAPulseAreNotSteppedOver) {
  Pulse system;
  auto integrator = make(system, 1e-4);
  integrator->initialize(0, Values{0});
  run_to(*integrator, Pulse::middle - 5 * Pulse::width);
  for (int k = -49; k <= 50; ++k) run_to(*integrator, Pulse::middle + 0.1 * k * Pulse::width);
  run_to(*integrator, 1000);
  const double exact = 1000 + Pulse::height * Pulse::width * std::sqrt(std::numbers::pi);
  EXPECT_NEAR(integrator->state()[0] / exact, 1, 1e-2);
}

TEST_P(Limits, StartFarFromZero) {
  LinearSystem system({-1.0});
  auto integrator = make(system, 1e-4);
  integrator->initialize(1e6, Values{1});
  run_to(*integrator, 1e6 + 0.5);
  run_to(*integrator, 1e6 + 1);
  EXPECT_NEAR(integrator->state()[0], std::exp(-1), 2e-3);
}

TEST_P(Limits, InterpolatesWithinTheLastStep) {
  LinearSystem system({-1.0});
  auto integrator = make(system, 1e-4);
  integrator->initialize(0, Values{1});
  Values y(1);
  integrator->interpolate(0, y);
  EXPECT_EQ(y[0], 1);
  double begin = 0;
  while (integrator->time() < 2) {
    integrator->step(2);
    for (double theta : {0.0, 0.3, 0.7, 1.0}) {
      const double t = std::min(begin + theta * (integrator->time() - begin), integrator->time());
      integrator->interpolate(t, y);
      EXPECT_NEAR(y[0], std::exp(-t), 2e-3) << "t = " << t;
    }
    EXPECT_EQ(y[0], integrator->state()[0]);
    EXPECT_THROW(integrator->interpolate(integrator->time() + 1, y), std::out_of_range);
    EXPECT_THROW(integrator->interpolate(begin - 1, y), std::out_of_range);
    begin = integrator->time();
  }
}

TEST_P(Limits, TakesAProposedStepForRestart) {
  if (is_euler(GetParam())) GTEST_SKIP() << "the options give the step";
  LinearSystem system({-1.0});
  auto integrator = make(system, 1e-3);
  integrator->initialize(0, Values{1}, 1e-3);
  EXPECT_NEAR(integrator->step(2).step, 1e-3, 1e-9);
  while (integrator->time() < 1) integrator->step(2);
  const double proposal = integrator->next_step();
  EXPECT_GT(proposal, 1e-3);
  run_to(*integrator, 1.0001 * integrator->time());
  EXPECT_GE(integrator->next_step(), 0.5 * proposal) << "the cut step must not become the proposal";
}

/// The right-hand side jumps at t = 1 from decay to growth.
TEST_P(Limits, StartsAnewAfterAJump) {
  LinearSystem before({-1.0});
  LinearSystem after({1.0});
  struct Switched : System {
    System* now;
    std::size_t size() const override { return 1; }
    void rate(double t, std::span<const double> y, std::span<double> r) override { now->rate(t, y, r); }
    JacobianProducts* jacobian() override { return now->jacobian(); }
    NewtonSolver* newton_solver() override { return now->newton_solver(); }
    double stable_step(double t, std::span<const double> y) override { return now->stable_step(t, y); }
    std::span<const double> scale() const override { return now->scale(); }
    void accept(double t, std::span<const double> y) override { now->accept(t, y); }
    Counters counters() const override { return now->counters(); }
  } system;
  system.now = &before;
  auto integrator = make(system, 1e-4);
  integrator->initialize(0, Values{1});
  run_to(*integrator, 1);
  const auto steps = integrator->counters().steps;
  EXPECT_GT(steps, 3);
  const Values y(integrator->state().begin(), integrator->state().end());
  system.now = &after;
  integrator->initialize(1, y);
  EXPECT_EQ(integrator->time(), 1);
  EXPECT_EQ(integrator->counters().steps, steps) << "counters go on";
  run_to(*integrator, 2);
  EXPECT_NEAR(integrator->state()[0], 1, 4e-3);
  EXPECT_GT(integrator->counters().steps, steps + 3);
}

INSTANTIATE_TEST_SUITE_P(All, Limits, testing::ValuesIn(all_names()), test_name);

}  // namespace
}  // namespace creepcontact::ode
