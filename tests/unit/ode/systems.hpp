#pragma once
/// Small systems with known solutions, which count and check what an integrator asks of them.

#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/ode/integrator.hpp"

namespace creepcontact::ode {

using Values = std::vector<double>;

/// Counts calls and records where they were made. A test system defines f, its Jacobian product and the diagonal.
class TestSystem : public System, public JacobianProducts, public NewtonSolver {
 public:
  TestSystem(std::size_t size, double scale);
  ~TestSystem() override;

  std::size_t size() const override { return scale_.size(); }
  std::span<const double> scale() const override { return scale_; }

  void rate(double t, std::span<const double> y, std::span<double> rate) override;
  void jacobian_times(double t, std::span<const double> y, std::span<const double> v,
                      std::span<double> product) override;
  void prepare_preconditioner(double t, std::span<const double> y) override;
  void precondition(double gamma, std::span<const double> r, std::span<double> z) override;
  void prepare_tangent(double t, std::span<const double> y, double gamma) override;
  void solve_tangent(std::span<const double> r, std::span<double> z) override;
  double stable_step(double t, std::span<const double> y) override;
  void accept(double t, std::span<const double> y) override;
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
  bool at_last_rate(double t, std::span<const double> y) const;

  Values scale_;
  Values diagonal_;
  struct Tangent;  // factored
  std::unique_ptr<Tangent> tangent_;
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
  double exact(std::size_t i, double t, double y0) const;

 protected:
  void f(double t, std::span<const double> y, std::span<double> rate) const override;
  void df(double, std::span<const double>, std::span<const double> v, std::span<double> product) const override;
  void local(double, std::span<const double>, std::span<double> diagonal) const override;

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
  static double exact_stress(double t);

 protected:
  void f(double, std::span<const double> y, std::span<double> rate) const override;
  void df(double t, std::span<const double> y, std::span<const double> v, std::span<double> product) const override;
  void local(double, std::span<const double> y, std::span<double> diagonal) const override;
};

/// Equal bars side by side share a constant force; their creep rates are graded over `grading`. The total strain
/// couples them: sigma_i = mean stress + E (mean(y) - y_i). Steady state: all rates alike.
class ParallelBars : public TestSystem {
 public:
  static constexpr double E = 2e5, n = 5, mean_stress = 100;
  ParallelBars(std::size_t bars, double grading);
  Values stress(std::span<const double> y) const;
  double steady_stress(std::size_t i) const;

 protected:
  void f(double, std::span<const double> y, std::span<double> rate) const override;
  void df(double t, std::span<const double> y, std::span<const double> v, std::span<double> product) const override;
  void local(double, std::span<const double> y, std::span<double> diagonal) const override;

 private:
  Values A_;
};

/// State at every time of `times` (ascending), read from the dense output; ends with a step onto the last one.
std::vector<Values> integrate(Integrator& integrator, double t0, const Values& y0, const Values& times);

/// "beta_euler_newton_adaptive" -> "beta_euler"
std::string registered_name(const std::string& variant);

/// Settings with which every integrator, or variant of one, reaches roughly the accuracy `tolerance` on the test
/// systems: the Euler schemes without error control by their step.
IntegratorOptions accurate_options(const std::string& variant, double tolerance);

std::unique_ptr<Integrator> make_variant(const std::string& variant, System& system, const IntegratorOptions& options);

}  // namespace creepcontact::ode
