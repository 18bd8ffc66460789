#include "unit/ode/systems.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "creepcontact/base/index.hpp"

namespace creepcontact::ode {

struct TestSystem::Tangent {
  Eigen::PartialPivLU<Eigen::MatrixXd> factor;
};

TestSystem::TestSystem(std::size_t size, double scale) : scale_(size, scale), tangent_(std::make_unique<Tangent>()) {}
TestSystem::~TestSystem() = default;

void TestSystem::rate(double t, std::span<const double> y, std::span<double> rate) {
  ++counters_.rate_evaluations;
  if (interceptor) interceptor(t, y);
  f(t, y, rate);
  last_t_ = t;
  last_y_.assign(y.begin(), y.end());
}

void TestSystem::jacobian_times(double t, std::span<const double> y, std::span<const double> v,
                                std::span<double> product) {
  ++counters_.jacobian_products;
  if (!at_last_rate(t, y)) ++calls_elsewhere;
  df(t, y, v, product);
}

void TestSystem::prepare_preconditioner(double t, std::span<const double> y) {
  ++preparations;
  if (!at_last_rate(t, y)) ++calls_elsewhere;
  diagonal_.resize(y.size());
  local(t, y, diagonal_);
}

void TestSystem::precondition(double gamma, std::span<const double> r, std::span<double> z) {
  gammas.push_back(gamma);
  for (std::size_t i = 0; i < r.size(); ++i) z[i] = r[i] / (1 - gamma * diagonal_[i]);
}

void TestSystem::prepare_tangent(double t, std::span<const double> y, double gamma) {
  ++factorizations;
  if (tangent_interceptor) tangent_interceptor(gamma);
  if (!at_last_rate(t, y)) ++calls_elsewhere;
  gammas.push_back(gamma);
  const Index n = y.size();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n);
  Values unit(y.size()), column(y.size());
  for (std::size_t j = 0; j < y.size(); ++j) {
    unit[j] = 1;
    df(t, y, unit, column);
    unit[j] = 0;
    matrix.col(j) -= gamma * Eigen::Map<const Eigen::VectorXd>(column.data(), n);
  }
  tangent_->factor.compute(matrix);
}

void TestSystem::solve_tangent(std::span<const double> r, std::span<double> z) {
  ++tangent_solves;
  const Index n = r.size();
  Eigen::Map<Eigen::VectorXd>(z.data(), n) = tangent_->factor.solve(Eigen::Map<const Eigen::VectorXd>(r.data(), n));
}

double TestSystem::stable_step(double t, std::span<const double> y) {
  Values diagonal(y.size());
  local(t, y, diagonal);
  double fastest = 0;
  for (double d : diagonal) fastest = std::max(fastest, std::abs(d));
  return 2 / fastest;
}

void TestSystem::accept(double t, std::span<const double> y) {
  accepted_times.push_back(t);
  accepted.assign(y.begin(), y.end());
}

bool TestSystem::at_last_rate(double t, std::span<const double> y) const {
  return t == last_t_ && std::ranges::equal(y, last_y_);
}

double LinearSystem::exact(std::size_t i, double t, double y0) const {
  return forced_ ? std::cos(t) + (y0 - 1) * std::exp(lambda_[i] * t) : y0 * std::exp(lambda_[i] * t);
}

void LinearSystem::f(double t, std::span<const double> y, std::span<double> rate) const {
  const double target = forced_ ? std::cos(t) : 0;
  const double slope = forced_ ? -std::sin(t) : 0;
  for (std::size_t i = 0; i < y.size(); ++i) rate[i] = lambda_[i] * (y[i] - target) + slope;
}

void LinearSystem::df(double, std::span<const double>, std::span<const double> v, std::span<double> product) const {
  for (std::size_t i = 0; i < v.size(); ++i) product[i] = lambda_[i] * v[i];
}

void LinearSystem::local(double, std::span<const double>, std::span<double> diagonal) const {
  std::ranges::copy(lambda_, diagonal.begin());
}

double RelaxingBar::exact_stress(double t) {
  return std::pow(std::pow(initial_stress, 1 - n) + (n - 1) * A * E * t, 1 / (1 - n));
}

void RelaxingBar::f(double, std::span<const double> y, std::span<double> rate) const {
  const double s = stress(y[0]);
  rate[0] = A * std::pow(std::abs(s), n - 1) * s;
}

void RelaxingBar::df(double t, std::span<const double> y, std::span<const double> v, std::span<double> product) const {
  local(t, y, product);
  product[0] *= v[0];
}

void RelaxingBar::local(double, std::span<const double> y, std::span<double> diagonal) const {
  diagonal[0] = -E * n * A * std::pow(std::abs(stress(y[0])), n - 1);
}

ParallelBars::ParallelBars(std::size_t bars, double grading) : TestSystem(bars, mean_stress / E), A_(bars) {
  for (std::size_t i = 0; i < bars; ++i)
    A_[i] = 1e-14 * std::pow(grading, static_cast<double>(i) / static_cast<double>(bars - 1));
}

Values ParallelBars::stress(std::span<const double> y) const {
  double mean = 0;
  for (double e : y) mean += e / static_cast<double>(y.size());
  Values s;
  for (double e : y) s.push_back(mean_stress + E * (mean - e));
  return s;
}

double ParallelBars::steady_stress(std::size_t i) const {
  double mean = 0;
  for (double a : A_) mean += std::pow(a, -1 / n) / static_cast<double>(A_.size());
  return mean_stress * std::pow(A_[i], -1 / n) / mean;
}

void ParallelBars::f(double, std::span<const double> y, std::span<double> rate) const {
  const Values s = stress(y);
  for (std::size_t i = 0; i < y.size(); ++i) rate[i] = A_[i] * std::pow(std::abs(s[i]), n - 1) * s[i];
}

void ParallelBars::df(double t, std::span<const double> y, std::span<const double> v, std::span<double> product) const {
  local(t, y, product);
  double mean = 0;
  for (double e : v) mean += e / static_cast<double>(v.size());
  for (std::size_t i = 0; i < v.size(); ++i) product[i] *= v[i] - mean;
}

void ParallelBars::local(double, std::span<const double> y, std::span<double> diagonal) const {
  const Values s = stress(y);
  for (std::size_t i = 0; i < y.size(); ++i) diagonal[i] = -E * n * A_[i] * std::pow(std::abs(s[i]), n - 1);
}

std::vector<Values> integrate(Integrator& integrator, double t0, const Values& y0, const Values& times) {
  integrator.initialize(t0, y0);
  std::vector<Values> states;
  for (double t : times) {
    while (integrator.time() < t) integrator.step(times.back());
    states.emplace_back(y0.size());
    integrator.interpolate(t, states.back());
  }
  return states;
}

std::string registered_name(const std::string& variant) {
  return variant.substr(0, std::min(variant.find("_newton"), variant.find("_adaptive")));
}

IntegratorOptions accurate_options(const std::string& variant, double tolerance) {
  IntegratorOptions options{.tolerance = tolerance};
  if (variant == "explicit_euler") options.step_factor = std::min(0.5, 20 * tolerance);
  if (variant.starts_with("beta_euler")) {
    options.beta = 0.5;
    options.step_factor = std::min(0.5, 5 * std::sqrt(tolerance));
    options.inner_tolerance = 1e-13;
  }
  if (variant.find("_newton") != std::string::npos) options.inner = InnerIteration::newton;
  if (variant.ends_with("_adaptive")) options.step = StepMode::adaptive;
  // The tolerance holds for a step; the number of steps of a method of first order grows with its inverse root.
  if (variant == "explicit_euler_adaptive") options.tolerance = std::min(1.0, 10 * tolerance) * tolerance;
  return options;
}

std::unique_ptr<Integrator> make_variant(const std::string& variant, System& system, const IntegratorOptions& options) {
  return make_integrator(registered_name(variant), system, options);
}

}  // namespace creepcontact::ode
