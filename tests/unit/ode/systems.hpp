#pragma once
/// Small systems with known solutions, which count and check what an integrator asks of them.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/ode/integrator.hpp"

namespace creepcontact::ode {

using Values = std::vector<double>;

/// Counts calls and records where they were made. A test system defines f, its Jacobian product and the diagonal.
class TestSystem : public System, public JacobianProducts, public NewtonSolver {
 public:
  TestSystem(std::size_t size, double scale) : scale_(size, scale) {}

  std::size_t size() const override { return scale_.size(); }
  std::span<const double> scale() const override { return scale_; }

  void rate(double t, std::span<const double> y, std::span<double> rate) override {
    ++counters_.rate_evaluations;
    if (interceptor) interceptor(t, y);
    f(t, y, rate);
    last_t_ = t;
    last_y_.assign(y.begin(), y.end());
  }
  void jacobian_times(double t, std::span<const double> y, std::span<const double> v,
                      std::span<double> product) override {
    ++counters_.jacobian_products;
    if (!at_last_rate(t, y)) ++calls_elsewhere;
    df(t, y, v, product);
  }
  void prepare_preconditioner(double t, std::span<const double> y) override {
    ++preparations;
    if (!at_last_rate(t, y)) ++calls_elsewhere;
    diagonal_.resize(y.size());
    local(t, y, diagonal_);
  }
  void precondition(double gamma, std::span<const double> r, std::span<double> z) override {
    gammas.push_back(gamma);
    for (std::size_t i = 0; i < r.size(); ++i) z[i] = r[i] / (1 - gamma * diagonal_[i]);
  }
  void prepare_tangent(double t, std::span<const double> y, double gamma) override {
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
    tangent_.compute(matrix);
  }
  void solve_tangent(std::span<const double> r, std::span<double> z) override {
    ++tangent_solves;
    const Index n = r.size();
    Eigen::Map<Eigen::VectorXd>(z.data(), n) = tangent_.solve(Eigen::Map<const Eigen::VectorXd>(r.data(), n));
  }
  double stable_step(double t, std::span<const double> y) override {
    Values diagonal(y.size());
    local(t, y, diagonal);
    double fastest = 0;
    for (double d : diagonal) fastest = std::max(fastest, std::abs(d));
    return 2 / fastest;
  }
  void accept(double t, std::span<const double> y) override {
    accepted_times.push_back(t);
    accepted.assign(y.begin(), y.end());
  }
  JacobianProducts* jacobian() override { return this; }
  NewtonSolver* newton_solver() override { return this; }
  Counters counters() const override { return counters_; }

  /// Called before every rate evaluation; may throw.
  std::function<void(double, std::span<const double>)> interceptor;
  /// Called before every factorisation; may throw.
  std::function<void(double gamma)> tangent_interceptor;
  int calls_elsewhere = 0;  ///< Jacobian products and preparations at another point than the last rate evaluation
  int preparations = 0;
  int tangent_solves = 0;
  int factorizations = 0;
  Values gammas;
  Values accepted_times;
  Values accepted;

 protected:
  virtual void f(double t, std::span<const double> y, std::span<double> rate) const = 0;
  virtual void df(double t, std::span<const double> y, std::span<const double> v, std::span<double> product) const = 0;
  virtual void local(double t, std::span<const double> y, std::span<double> diagonal) const = 0;

 private:
  bool at_last_rate(double t, std::span<const double> y) const {
    return t == last_t_ && std::ranges::equal(y, last_y_);
  }
  Values scale_;
  Values diagonal_;
  Eigen::PartialPivLU<Eigen::MatrixXd> tangent_;
  double last_t_ = std::numeric_limits<double>::quiet_NaN();
  Values last_y_;
  Counters counters_;
};

/// y_i' = lambda_i (y_i - cos(t)) - sin(t): y_i = cos(t) + (y_i(0) - 1) exp(lambda_i t). Without forcing: y' = lambda
/// y.
class LinearSystem : public TestSystem {
 public:
  explicit LinearSystem(Values lambda, bool forced = false, double scale = 1)
      : TestSystem(lambda.size(), scale), lambda_(std::move(lambda)), forced_(forced) {}
  double exact(std::size_t i, double t, double y0) const {
    return forced_ ? std::cos(t) + (y0 - 1) * std::exp(lambda_[i] * t) : y0 * std::exp(lambda_[i] * t);
  }

 protected:
  void f(double t, std::span<const double> y, std::span<double> rate) const override {
    const double target = forced_ ? std::cos(t) : 0;
    const double slope = forced_ ? -std::sin(t) : 0;
    for (std::size_t i = 0; i < y.size(); ++i) rate[i] = lambda_[i] * (y[i] - target) + slope;
  }
  void df(double, std::span<const double>, std::span<const double> v, std::span<double> product) const override {
    for (std::size_t i = 0; i < v.size(); ++i) product[i] = lambda_[i] * v[i];
  }
  void local(double, std::span<const double>, std::span<double> diagonal) const override {
    std::ranges::copy(lambda_, diagonal.begin());
  }

 private:
  Values lambda_;
  bool forced_;
};

/// NAFEMS R0027 1B: a bar held at its length relaxes by Norton creep; the state is its creep strain [-], hours.
class RelaxingBar : public TestSystem {
 public:
  static constexpr double E = 2e5, A = 3.125e-14, n = 5, initial_stress = 200;
  RelaxingBar() : TestSystem(1, initial_stress / E) {}
  static double stress(double y) { return initial_stress - E * y; }
  static double exact_stress(double t) {
    return std::pow(std::pow(initial_stress, 1 - n) + (n - 1) * A * E * t, 1 / (1 - n));
  }

 protected:
  void f(double, std::span<const double> y, std::span<double> rate) const override {
    const double s = stress(y[0]);
    rate[0] = A * std::pow(std::abs(s), n - 1) * s;
  }
  void df(double t, std::span<const double> y, std::span<const double> v, std::span<double> product) const override {
    local(t, y, product);
    product[0] *= v[0];
  }
  void local(double, std::span<const double> y, std::span<double> diagonal) const override {
    diagonal[0] = -E * n * A * std::pow(std::abs(stress(y[0])), n - 1);
  }
};

/// Equal bars side by side share a constant force; their creep rates are graded over `grading`. The total strain
/// couples them: sigma_i = mean stress + E (mean(y) - y_i). Steady state: all rates alike.
class ParallelBars : public TestSystem {
 public:
  static constexpr double E = 2e5, n = 5, mean_stress = 100;
  ParallelBars(std::size_t bars, double grading) : TestSystem(bars, mean_stress / E), A_(bars) {
    for (std::size_t i = 0; i < bars; ++i)
      A_[i] = 1e-14 * std::pow(grading, static_cast<double>(i) / static_cast<double>(bars - 1));
  }
  Values stress(std::span<const double> y) const {
    double mean = 0;
    for (double e : y) mean += e / static_cast<double>(y.size());
    Values s;
    for (double e : y) s.push_back(mean_stress + E * (mean - e));
    return s;
  }
  double steady_stress(std::size_t i) const {
    double mean = 0;
    for (double a : A_) mean += std::pow(a, -1 / n) / static_cast<double>(A_.size());
    return mean_stress * std::pow(A_[i], -1 / n) / mean;
  }

 protected:
  void f(double, std::span<const double> y, std::span<double> rate) const override {
    const Values s = stress(y);
    for (std::size_t i = 0; i < y.size(); ++i) rate[i] = A_[i] * std::pow(std::abs(s[i]), n - 1) * s[i];
  }
  void df(double t, std::span<const double> y, std::span<const double> v, std::span<double> product) const override {
    local(t, y, product);
    double mean = 0;
    for (double e : v) mean += e / static_cast<double>(v.size());
    for (std::size_t i = 0; i < v.size(); ++i) product[i] *= v[i] - mean;
  }
  void local(double, std::span<const double> y, std::span<double> diagonal) const override {
    const Values s = stress(y);
    for (std::size_t i = 0; i < y.size(); ++i) diagonal[i] = -E * n * A_[i] * std::pow(std::abs(s[i]), n - 1);
  }

 private:
  Values A_;
};

/// State at every time of `times` (ascending), read from the dense output; ends with a step onto the last one.
inline std::vector<Values> integrate(Integrator& integrator, double t0, const Values& y0, const Values& times) {
  integrator.initialize(t0, y0);
  std::vector<Values> states;
  for (double t : times) {
    while (integrator.time() < t) integrator.step(times.back());
    states.emplace_back(y0.size());
    integrator.interpolate(t, states.back());
  }
  return states;
}

/// "beta_euler_newton_adaptive" -> "beta_euler"
inline std::string registered_name(const std::string& variant) {
  return variant.substr(0, std::min(variant.find("_newton"), variant.find("_adaptive")));
}

/// Settings with which every integrator, or variant of one, reaches roughly the accuracy `tolerance` on the test
/// systems: the Euler schemes without error control by their step.
inline IntegratorOptions accurate_options(const std::string& variant, double tolerance) {
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

inline std::unique_ptr<Integrator> make_variant(const std::string& variant, System& system,
                                                const IntegratorOptions& options) {
  return make_integrator(registered_name(variant), system, options);
}

}  // namespace creepcontact::ode
