#include <gtest/gtest.h>

#include <cmath>

#include "creepcontact/base/error.hpp"
#include "systems.hpp"

namespace creepcontact::ode {
namespace anderson_tests {
namespace {

constexpr double never = 1e9;

/// Eight relaxing bars of their own, their strains in fixed proportion: the residuals of all iterations are parallel,
/// exactly so if the bars are equal.
class ProportionalBars : public TestSystem {
 public:
  explicit ProportionalBars(double grading) : TestSystem(8, RelaxingBar::initial_stress / RelaxingBar::E) {
    for (int i = 0; i < 8; ++i) weight_.push_back(1 + grading * i);
  }
  double weight(std::size_t i) const { return weight_[i]; }

 protected:
  void f(double, std::span<const double> y, std::span<double> rate) const override {
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double s = RelaxingBar::stress(y[i] / weight_[i]);
      rate[i] = weight_[i] * RelaxingBar::A * std::pow(std::abs(s), RelaxingBar::n - 1) * s;
    }
  }
  void df(double t, std::span<const double> y, std::span<const double> v, std::span<double> product) const override {
    local(t, y, product);
    for (std::size_t i = 0; i < v.size(); ++i) product[i] *= v[i];
  }
  void local(double, std::span<const double> y, std::span<double> diagonal) const override {
    for (std::size_t i = 0; i < y.size(); ++i)
      diagonal[i] = -RelaxingBar::E * RelaxingBar::n * RelaxingBar::A *
                    std::pow(std::abs(RelaxingBar::stress(y[i] / weight_[i])), RelaxingBar::n - 1);
  }

 private:
  Values weight_;
};

/// The longest step from the elastic state for which plain iterations contract.
double contraction_bound(TestSystem& system, double beta) {
  return system.stable_step(0, Values(system.size())) / (2 * beta);
}

struct Outcome {
  Values state;
  std::int64_t evaluations = 0;
};
Outcome steps(TestSystem& system, int count, const IntegratorOptions& options) {
  auto integrator = make_integrator("beta_euler", system, options);
  integrator->initialize(0, Values(system.size()));
  for (int k = 0; k < count; ++k) integrator->step(never);
  return {Values(integrator->state().begin(), integrator->state().end()), system.counters().rate_evaluations};
}

TEST(InnerAnderson, GivesTheSolutionOfThePlainIterations) {
  constexpr double tolerance = 1e-12;
  constexpr int count = 10;
  for (double beta : {0.5, 1.0})
    for (int depth : {1, 3, 20}) {
      ParallelBars plain(8, 100), accelerated(8, 100);
      IntegratorOptions options{.step = 0.5 * contraction_bound(plain, beta), .beta = beta};
      options.inner_tolerance = tolerance;
      const Values expected = steps(plain, count, options).state;
      options.inner_anderson = depth;
      const Values found = steps(accelerated, count, options).state;
      // Contraction by a half leaves an error of at most the last change in either, step after step.
      for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], 2 * count * tolerance) << "beta " << beta << " depth " << depth;
    }
}

void expect_plain_iterations_fail(TestSystem& system, IntegratorOptions options) {
  options.inner_anderson = 0;
  try {
    steps(system, 1, options);
    ADD_FAILURE() << "plain iterations converge";
  } catch (const SolverError& error) {
    EXPECT_NE(std::string(error.what()).find("inner_anderson"), std::string::npos) << error.what();
  }
}

TEST(InnerAnderson, ConvergesThreeTimesBeyondThePlainBound) {
  const Values lambda{-1.0, -0.5, -0.1, -0.01};
  for (double beta : {0.5, 0.75, 1.0})
    for (int depth : {1, 3, 20}) {
      LinearSystem system(lambda, true);
      IntegratorOptions options{.step = 3 * contraction_bound(system, beta), .beta = beta, .inner_tolerance = 1e-12};
      options.inner_anderson = depth;
      expect_plain_iterations_fail(system, options);
      const double dt = options.step.length;
      const Values y = steps(system, 1, options).state;
      for (std::size_t i = 0; i < lambda.size(); ++i) {  // y' = lambda (y - cos t) - sin t from y = 0
        const double explicit_part = dt * (1 - beta) * -lambda[i];
        const double implicit_part = dt * beta * (-lambda[i] * std::cos(dt) - std::sin(dt));
        EXPECT_NEAR(y[i], (explicit_part + implicit_part) / (1 - beta * dt * lambda[i]), 1e-12) << "depth " << depth;
      }
    }
}

TEST(InnerAnderson, ConvergesThreeTimesBeyondThePlainBoundForCreep) {
  constexpr double tolerance = 1e-12;
  for (int depth : {1, 3, 20}) {
    ParallelBars bars(8, 100);
    IntegratorOptions options{.step = 3 * contraction_bound(bars, 1), .beta = 1, .inner_tolerance = tolerance};
    options.inner_anderson = depth;
    expect_plain_iterations_fail(bars, options);
    const Values y = steps(bars, 1, options).state;
    Values rate(8);
    bars.rate(options.step.length, y, rate);
    // y is the image of an argument within the tolerance; the map amplifies at most threefold.
    for (std::size_t i = 0; i < 8; ++i)
      EXPECT_NEAR(y[i], options.step.length * rate[i], 3 * tolerance) << "depth " << depth;
  }
}

TEST(InnerAnderson, SavesEvaluationsNearTheBound) {
  ParallelBars plain(8, 100), accelerated(8, 100);
  IntegratorOptions options{.step = 0.9 * contraction_bound(plain, 1), .beta = 1};
  const std::int64_t before = steps(plain, 10, options).evaluations;
  options.inner_anderson = 3;
  EXPECT_LT(2 * steps(accelerated, 10, options).evaluations, before + 10);
}

TEST(InnerAnderson, ParallelResidualsDoNoHarm) {
  for (double grading : {0.0, 0.1})
    for (int depth : {1, 3, 5}) {
      ProportionalBars bars(grading);
      RelaxingBar bar;
      const double step = 3 * contraction_bound(bar, 1);
      const double strain = steps(bar, 5, {.step = step, .inner_tolerance = 1e-14, .inner_anderson = 1}).state[0];
      const Outcome run = steps(bars, 5, {.step = step, .inner_tolerance = 1e-14, .inner_anderson = depth});
      for (std::size_t i = 0; i < bars.size(); ++i)
        EXPECT_NEAR(run.state[i] / bars.weight(i), strain, 1e-13) << "grading " << grading << " depth " << depth;
      EXPECT_LT(run.evaluations, 100) << "grading " << grading << " depth " << depth;
    }
}

TEST(InnerAnderson, ResidualCorrectionIsTheArgumentOfTheLastEvaluation) {
  for (double gamma : {0.0, 0.5, 1.0}) {
    RelaxingBar bar;
    const double step = 2 * contraction_bound(bar, 1);
    Values arguments;
    bar.interceptor = [&](double, std::span<const double> y) { arguments.push_back(y[0]); };
    auto integrator = make_integrator(
        "beta_euler", bar, {.step = step, .inner_tolerance = 1e-6, .inner_anderson = 2, .residual_correction = gamma});
    integrator->initialize(0, Values{0});
    integrator->step(never);
    ASSERT_GT(arguments.size(), 4u) << "the acceleration takes part from the third iteration";
    const double e = arguments.back();
    const double y = integrator->state()[0];
    Values rate(1);
    bar.interceptor = nullptr;
    bar.rate(step, Values{e}, rate);
    EXPECT_NEAR(y, step * rate[0], 1e-18) << "the new state is the image of e";
    ASSERT_NE(y, e);
    double first = 0;
    bar.interceptor = [&](double, std::span<const double> argument) {
      if (first == 0) first = argument[0];
    };
    integrator->step(never);
    EXPECT_NEAR(first, y + step * rate[0] - (1 - gamma) * (y - e), 1e-18) << gamma;
  }
}

TEST(InnerAnderson, FailureToConvergeIsReportedAndKeepsTheState) {
  struct Case {
    double steps;  ///< in units of the contraction bound
    int max_iterations;
    const char* what;
  };
  for (const Case& c : {Case{3, 4, "do not converge"}, Case{100, 200, "diverge"}}) {
    ParallelBars bars(8, 100);
    auto integrator = make_integrator(
        "beta_euler", bars,
        {.step = c.steps * contraction_bound(bars, 1), .max_inner_iterations = c.max_iterations, .inner_anderson = 3});
    integrator->initialize(0, Values(8));
    try {
      integrator->step(never);
      ADD_FAILURE() << c.what;
    } catch (const SolverError& error) {
      const std::string message = error.what();
      for (const char* part : {c.what, "stable / (2 beta)", "inner_anderson = 3", "smaller step", "cvode_bdf"})
        EXPECT_NE(message.find(part), std::string::npos) << message;
    }
    EXPECT_LE(bars.counters().rate_evaluations, 1 + c.max_iterations);
    EXPECT_EQ(integrator->time(), 0);
    EXPECT_EQ(integrator->state()[0], 0);
  }
}

TEST(InnerAnderson, RecoverableErrorsAreAnsweredByASmallerStep) {
  // Rates exist for the next 0.1 only: the step of 0.5 must be halved three times, as with plain iterations.
  for (int depth : {0, 3}) {
    LinearSystem system({-1.0, -0.5});
    system.interceptor = [&](double t, std::span<const double>) {
      if (t > 0.1) throw RecoverableError("the contact did not converge");
    };
    auto integrator = make_integrator("beta_euler", system, {.step = 0.5, .inner_anderson = depth});
    integrator->initialize(0, Values{1, 1});
    EXPECT_EQ(integrator->step(1).step, 0.0625) << depth;
    EXPECT_EQ(integrator->counters().convergence_failures, 3) << depth;
    EXPECT_NEAR(integrator->state()[0], 1 / 1.0625, 1e-9) << depth;
  }
}

TEST(InnerAnderson, OtherExceptionsComeThroughFromAnyIteration) {
  struct Broken : std::logic_error {
    using std::logic_error::logic_error;
  };
  for (int fatal : {1, 2, 4}) {
    ParallelBars bars(8, 100);
    auto integrator =
        make_integrator("beta_euler", bars, {.step = 2 * contraction_bound(bars, 1), .inner_anderson = 3});
    integrator->initialize(0, Values(8));
    int calls = 0;
    bars.interceptor = [&](double, std::span<const double>) {
      if (++calls == fatal) throw Broken("out of order");
    };
    EXPECT_THROW(integrator->step(never), Broken) << fatal;
    EXPECT_EQ(calls, fatal);
    EXPECT_EQ(integrator->time(), 0);
    EXPECT_EQ(integrator->state()[0], 0);
    integrator->step(never);
    EXPECT_GT(integrator->state()[0], 0) << "the integrator is as good as before";
  }
}

TEST(InnerAnderson, DepthMustNotBeNegative) {
  LinearSystem system({-1.0});
  EXPECT_THROW(make_integrator("beta_euler", system, {.inner_anderson = -1}), ConfigError);
}

}  // namespace
}  // namespace anderson_tests
}  // namespace creepcontact::ode
