// Creep strain that grows as t^m from a point where its rate is infinite.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "every_integrator.hpp"

namespace creepcontact::ode {
namespace {

/// NAFEMS R0027 1B with primary creep, eps = A q^n t^m at constant stress, m = 1/2: a held bar relaxes.
/// State: creep strain; with strain hardening it is the hardening variable too. Loading begins at t0.
class PrimaryBar : public TestSystem, public SingularRate {
 public:
  static constexpr double E = 2e5, A = 3.125e-14, n = 5, m = 0.5, s0 = 200;
  PrimaryBar(bool strain_hardening, double t0) : TestSystem(1, s0 / E), hardening_(strain_hardening), t0_(t0) {}

  SingularRate* singular_rate() override { return this; }
  double start_exponent(double t, std::span<const double>) override { return t == t0_ ? m : 1; }
  void start_increment(double t, std::span<const double> y, double, double duration,
                       std::span<double> change) override {
    const double c = A * std::pow(stress(y[0]), n);
    change[0] += hardening_ ? std::pow(std::pow(y[0], 1 / m) + std::pow(c, 1 / m) * duration, m) - y[0]
                            : c * (std::pow(t - t0_ + duration, m) - std::pow(t - t0_, m));
  }
  static double stress(double y) { return s0 - E * y; }
  /// Since the loading began.
  double exact_time(double s) const {
    if (!hardening_) return std::pow((std::pow(s, 1 - n) - std::pow(s0, 1 - n)) / ((n - 1) * A * E), 1 / m);
    // eps eps' = A^2 s^10 / 2 with eps = (s0 - s)/E
    const auto antiderivative = [](double x) { return -s0 / 9 * std::pow(x, -9) + std::pow(x, -8) / 8; };
    return 2 / (A * A * E * E) * -(antiderivative(s) - antiderivative(s0));
  }

 protected:
  void f(double t, std::span<const double> y, std::span<double> rate) const override {
    const double s = std::max(stress(y[0]), 0.0);
    rate[0] = hardening_ ? m * std::pow(A * std::pow(s, n), 1 / m) * std::pow(std::max(y[0], 1e-12), 1 - 1 / m)
                         : A * std::pow(s, n) * m * std::pow(t - t0_, m - 1);
    if (!std::isfinite(rate[0])) throw std::runtime_error("evaluated in the singular point");
  }
  void df(double t, std::span<const double> y, std::span<const double> v, std::span<double> product) const override {
    local(t, y, product);
    product[0] *= v[0];
  }
  void local(double t, std::span<const double> y, std::span<double> diagonal) const override {
    Values rate(1);
    f(t, y, rate);
    const double s = stress(y[0]);
    diagonal[0] = hardening_ ? rate[0] * (-n / m * E / s + (1 - 1 / m) / y[0]) : -n * E / s * rate[0];
  }

 private:
  bool hardening_;
  double t0_;
};

class SingularStarts : public EveryIntegrator {};

double error_of_time(const PrimaryBar& bar, double s, double elapsed) {
  // ds/dt is known from the exact solution only: compare in the logarithm of the time, s changes by less than that.
  return std::abs(std::log(bar.exact_time(s) / elapsed));
}

TEST_P(SingularStarts, FollowsTheExactRelaxationFromTheSingularPoint) {
  for (const bool hardening : {false, true})
    for (const double t0 : {0.0, 100.0}) {
      if (t0 > 0 && !hardening) continue;  // the age counts from t = 0
      PrimaryBar bar(hardening, t0);
      const double tolerance = 1e-5;
      auto integrator = make(bar, tolerance);
      ASSERT_EQ(integrator->name(), registered_name(GetParam()));
      integrator->initialize(t0, Values{0.0});
      const double first_order = is_euler(GetParam()) || GetParam().starts_with("explicit") ? 2 : 1;
      for (const double elapsed : {0.1, 10.0, 1000.0}) {
        Values y(1);
        while (integrator->time() < t0 + elapsed) integrator->step(t0 + 1000);
        integrator->interpolate(t0 + elapsed, y);
        EXPECT_LT(error_of_time(bar, PrimaryBar::stress(y[0]), elapsed), 5e-3 * first_order)
            << (hardening ? "strain hardening, " : "time hardening, ") << "t0 = " << t0 << ", t - t0 = " << elapsed;
      }
      EXPECT_EQ(integrator->time(), t0 + 1000);
      const int max_steps = GetParam().starts_with("explicit_euler") ? 200000 : 5000;
      EXPECT_LT(integrator->counters().steps, max_steps) << hardening;
    }
}

TEST_P(SingularStarts, GoesOnFromARestartPoint) {
  PrimaryBar one(true, 0), other(true, 0);
  auto whole = make(one, 1e-5), resumed = make(other, 1e-5);
  whole->initialize(0, Values{0.0});
  RestartPoint first = whole->save();  // before any step
  while (whole->time() < 1 || !whole->at_restart_point()) whole->step(1000);
  const RestartPoint point = whole->save();
  resumed->restore(first);
  resumed->step(1000);
  resumed->restore(point);
  EXPECT_EQ(resumed->time(), whole->time());
  while (whole->time() < 1000) whole->step(1000);
  while (resumed->time() < 1000) resumed->step(1000);
  if (whole->restores_exactly())
    EXPECT_EQ(resumed->state()[0], whole->state()[0]);
  else
    EXPECT_NEAR(resumed->state()[0], whole->state()[0], 3e-5 * PrimaryBar::s0 / PrimaryBar::E);
}

INSTANTIATE_TEST_SUITE_P(All, SingularStarts, testing::ValuesIn(all_names()), test_name);

TEST(SingularStart, FixedStepsAreThoseThatAreAskedFor) {
  PrimaryBar bar(false, 0);
  IntegratorOptions options;
  options.step = 10.0;
  auto euler = make_integrator("explicit_euler", bar, options);
  euler->initialize(0, Values{0.0});
  for (const double end : {10.0, 20.0, 25.0, 35.0}) EXPECT_DOUBLE_EQ(euler->step(end == 25 ? 25 : 1000).time, end);
  EXPECT_EQ(euler->counters().steps, 4);
}

TEST(SingularStart, ConstantStressIsExactInAnyFixedStep) {
  struct LoadedBar : PrimaryBar {
    LoadedBar() : PrimaryBar(false, 0) {}
    void f(double t, std::span<const double>, std::span<double> rate) const override {
      rate[0] = A * std::pow(s0, n) * m * std::pow(t, m - 1);
    }
  } bar;
  IntegratorOptions options;
  options.step = 250.0;
  auto euler = make_integrator("explicit_euler", bar, options);
  euler->initialize(0, Values{0.0});
  while (euler->time() < 1000) euler->step(1000);
  EXPECT_NEAR(euler->state()[0], 1e-5 * std::sqrt(1000.0) * 1e3, 1e-10);
}

}  // namespace
}  // namespace creepcontact::ode
