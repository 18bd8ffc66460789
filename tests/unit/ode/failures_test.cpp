#include <cmath>
#include <string>

#include "creepcontact/base/error.hpp"
#include "every_integrator.hpp"

namespace creepcontact::ode {
namespace {

using Failures = EveryIntegrator;

TEST_P(Failures, RecoverableErrorsAreAnsweredByASmallerStep) {
  LinearSystem system({-1.0});
  IntegratorOptions options = accurate_options(GetParam(), 0.1);
  if (is_euler(GetParam())) options.step = 0.5;
  auto integrator = make_variant(GetParam(), system, options);
  int failures = 0;
  double reach = std::numeric_limits<double>::infinity();
  system.interceptor = [&](double t, std::span<const double>) {
    if (t > 0.2 && t - reach > 0.02 * (1 + 1e-12)) {
      ++failures;
      throw RecoverableError("the contact did not converge");
    }
  };
  integrator->initialize(0, Values{1}, 0.1);
  while (integrator->time() < 1) {
    reach = integrator->time();  // from here rates exist for the next 0.02 only
    integrator->step(1);
  }
  EXPECT_GT(failures, 0);
  EXPECT_GT(integrator->counters().convergence_failures, 0);
  EXPECT_GE(integrator->counters().steps, 40);
  EXPECT_NEAR(integrator->state()[0], std::exp(-1), 0.05);
}

TEST_P(Failures, OtherExceptionsComeThroughWithTheirType) {
  struct Broken : std::logic_error {
    using std::logic_error::logic_error;
  };
  LinearSystem system({-1.0});
  auto integrator = make(system, 1e-3);
  integrator->initialize(0, Values{1});
  while (integrator->time() < 0.5) integrator->step(2);
  const double time = integrator->time();
  const double y = integrator->state()[0];
  system.interceptor = [](double, std::span<const double>) { throw Broken("out of order"); };
  EXPECT_THROW(integrator->step(2), Broken);
  EXPECT_EQ(integrator->time(), time);
  EXPECT_EQ(integrator->state()[0], y);
  system.interceptor = nullptr;
  integrator->initialize(time, Values{y});
  while (integrator->time() < 1) integrator->step(1);
  EXPECT_NEAR(integrator->state()[0], std::exp(-1), 0.05);
}

/// y' = exp(10 y): y = -log(1 - 10 t)/10, which grows without bound at t = 0.1.
class Explosion : public TestSystem {
 public:
  Explosion() : TestSystem(1, 1) {}

 protected:
  void f(double, std::span<const double> y, std::span<double> rate) const override { rate[0] = std::exp(10 * y[0]); }
  void df(double, std::span<const double> y, std::span<const double> v, std::span<double> product) const override {
    product[0] = 10 * std::exp(10 * y[0]) * v[0];
  }
  void local(double, std::span<const double> y, std::span<double> diagonal) const override {
    diagonal[0] = 10 * std::exp(10 * y[0]);
  }
};

TEST_P(Failures, RatesThatGrowWithoutBoundEndTheSteps) {
  if (is_euler(GetParam())) return;  // its steps do not follow the rate
  Explosion system;
  auto integrator = make(system, 1e-3);
  integrator->initialize(0, Values{0});
  constexpr int many = 1000000;
  int steps = 0;
  EXPECT_THROW(while (integrator->time() < 1 && ++steps < many) integrator->step(1), SolverError)
      << "at t = " << integrator->time() << " after " << steps << " steps";
}

TEST_P(Failures, ImpossibleProblemGivesAdviceAndKeepsTheState) {
  LinearSystem system({-1.0});
  auto integrator = make(system, 1e-3);
  integrator->initialize(0, Values{1});
  system.interceptor = [](double t, std::span<const double>) {
    if (t > 0.7) throw RecoverableError("no equilibrium beyond 0.7");
  };
  double time = 0;
  double y = 1;
  std::string message;
  try {
    for (int k = 0; k < 10000; ++k) {
      integrator->step(2);
      time = integrator->time();
      y = integrator->state()[0];
    }
  } catch (const SolverError& error) {
    message = error.what();
    EXPECT_EQ(error.exit_status(), 4);
  }
  EXPECT_NE(message.find(registered_name(GetParam())), std::string::npos) << message;
  EXPECT_NE(message.find("no equilibrium beyond 0.7"), std::string::npos) << message;
  EXPECT_EQ(integrator->time(), time);
  EXPECT_EQ(integrator->state()[0], y);
  EXPECT_LE(time, 0.7);
  EXPECT_GT(time, 0.6);
  EXPECT_NEAR(y, std::exp(-time), 2e-2);
}

TEST_P(Failures, NoRateAtTheStart) {
  LinearSystem system({-1.0});
  system.interceptor = [](double, std::span<const double>) { throw RecoverableError("no equilibrium at all"); };
  auto integrator = make(system, 1e-3);
  EXPECT_THROW(
      {
        integrator->initialize(0, Values{1});
        integrator->step(1);
      },
      SolverError);
  EXPECT_EQ(integrator->time(), 0);
  EXPECT_EQ(integrator->state()[0], 1);
}

TEST_P(Failures, CountersGoOnOverRestarts) {
  LinearSystem system({-1.0});
  auto integrator = make(system, 1e-3);
  std::int64_t steps = 0;
  for (int run = 0; run < 3; ++run) {
    integrator->initialize(0, Values{1});
    EXPECT_EQ(integrator->counters().steps, steps);
    while (integrator->time() < 1) {
      integrator->step(1);
      EXPECT_EQ(integrator->counters().steps, ++steps);
    }
  }
}

TEST_P(Failures, LimitMustLieAhead) {
  LinearSystem system({-1.0});
  auto integrator = make(system, 1e-3);
  integrator->initialize(1, Values{1});
  EXPECT_THROW(integrator->step(1), std::invalid_argument);
  EXPECT_THROW(integrator->step(0.5), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(All, Failures, testing::ValuesIn(all_names()), test_name);

TEST(Registry, RefusesUnknownNamesAndSettingsOutOfRange) {
  LinearSystem system({-1.0});
  EXPECT_THROW(make_integrator("cvode", system, {}), std::out_of_range);
  EXPECT_THROW(make_integrator("beta_euler", system, {.beta = 0.49}), ConfigError);
  EXPECT_THROW(make_integrator("beta_euler", system, {.residual_correction = 1.5}), ConfigError);
  EXPECT_THROW(make_integrator("explicit_euler", system, {.step = -1}), ConfigError);
  EXPECT_THROW(make_integrator("cvode_bdf", system, {.tolerance = 0}), ConfigError);
  for (const IntegratorInfo& info : integrators()) EXPECT_FALSE(info.description.empty()) << info.name;
}

}  // namespace
}  // namespace creepcontact::ode
