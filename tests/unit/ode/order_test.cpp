/// How the error falls, and that all integrators find the same solution.

#include <algorithm>
#include <cmath>

#include "every_integrator.hpp"

namespace creepcontact::ode {
namespace {

using Order = EveryIntegrator;

/// Error of the stress of the relaxing bar, relative to the initial one, at its worst over the output times.
double worst_error(const std::string& variant, const IntegratorOptions& options) {
  RelaxingBar bar;
  auto integrator = make_variant(variant, bar, options);
  const Values times = {0.05, 0.2, 1, 5};
  const auto y = integrate(*integrator, 0, {0}, times);
  double worst = 0;
  for (std::size_t k = 0; k < times.size(); ++k)
    worst = std::max(worst, std::abs(RelaxingBar::stress(y[k][0]) - RelaxingBar::exact_stress(times[k])));
  return worst / RelaxingBar::initial_stress;
}

/// Without error control the error falls with the step to the power of the reported order ...
void expect_order(const std::string& variant) {
  IntegratorOptions options = accurate_options(variant, 1e-3);
  RelaxingBar bar;
  auto integrator = make_variant(variant, bar, options);
  integrator->initialize(0, Values{0});
  const int order = integrator->step(1).order;
  options.inner_tolerance = 1e-15;
  options.step = 1.0 / 1024;
  const double coarse = worst_error(variant, options);
  options.step = 1.0 / 2048;
  EXPECT_NEAR(std::log2(coarse / worst_error(variant, options)), order, 0.1);
}

/// ... with it, with the tolerance: the more so, the higher the order p, at most in proportion. One-step methods with
/// errors of order p + 1 per step go with its power p/(p + 1); multistep methods swing about it as their order changes.
void expect_control(const std::string& variant) {
  double least = 0.55;
  if (variant.starts_with("explicit_euler")) least = 0.45;
  const double coarse_tolerance = 1e-3, fine_tolerance = 1e-7;
  IntegratorOptions options = accurate_options(variant, coarse_tolerance);
  options.end_time = 5;
  options.tolerance = coarse_tolerance;
  const double coarse = worst_error(variant, options);
  options.tolerance = fine_tolerance;
  const double fine = worst_error(variant, options);
  const double power = std::log(coarse / fine) / std::log(coarse_tolerance / fine_tolerance);
  EXPECT_GT(power, least) << coarse << " " << fine;
  EXPECT_LT(power, 1.25) << coarse << " " << fine;
}

TEST_P(Order, ErrorFallsWithStepOrTolerance) {
  if (is_euler(GetParam()))
    expect_order(GetParam());
  else
    expect_control(GetParam());
}

/// Graded parallel bars of Norton's law, n = 5, under a constant force: coupled, nonlinear, stiff.
TEST_P(Order, AgreesOnCoupledBars) {
  constexpr std::size_t size = 6;
  const double tau = 1 / (ParallelBars::E * 1e-14 * 1e8);  // relaxation time of the slowest
  const Values times = {0.01 * tau, 0.1 * tau, tau};
  const auto solve = [&](const std::string& variant, double tolerance) {
    ParallelBars bars(size, 30);
    IntegratorOptions options = accurate_options(variant, tolerance);
    options.end_time = times.back();
    auto integrator = make_variant(variant, bars, options);
    std::vector<Values> stresses;
    for (const Values& y : integrate(*integrator, 0, Values(size), times)) stresses.push_back(bars.stress(y));
    return stresses;
  };
  static const std::vector<Values> reference = solve("cvode_bdf", 1e-9);
  const std::vector<Values> found = solve(GetParam(), 1e-4);
  for (std::size_t k = 0; k < times.size(); ++k)
    for (std::size_t i = 0; i < size; ++i)
      EXPECT_NEAR(found[k][i], reference[k][i], 1e-3 * ParallelBars::mean_stress)
          << "bar " << i << ", t = " << times[k];
}

INSTANTIATE_TEST_SUITE_P(All, Order, testing::ValuesIn(all_names()), test_name);

}  // namespace
}  // namespace creepcontact::ode
