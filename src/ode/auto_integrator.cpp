#include "auto_integrator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "relaxing_share.hpp"

namespace creepcontact::ode {
namespace {

constexpr std::size_t window = 30;        // steps looked back on
constexpr std::int64_t max_failures = 6;  // of the iterations in so many steps: a kink of a load costs some
/// Solves of cvode_bdf per step on average: where bodies relax a million times faster than others, GMRES needs many,
/// and the residual that remains keeps the steps short. The tangent stiffness then takes half the steps or fewer, and a
/// tenth of the solves.
constexpr double max_mean_products = 5;
constexpr std::size_t min_steps_before_tangent = 300;  // a restart costs more than some hundred steps of many products
/// Iterations of cvode_bdf that keep the steps short: at least so many failures in the window, while the errors are so
/// far below what they may be. The tangent stiffness then takes a thousandth of the steps in laws that hardly differ
/// from plasticity.
constexpr std::int64_t failures_of_short_steps = 2;
constexpr double error_of_short_steps = 0.05;
constexpr std::int64_t max_failures_of_tangent = 20;  // a failure costs a few solves, other methods far more

/// Part of the tolerance for cvode_bdf: its errors add up to three tolerances where stress relaxes by several
/// mechanisms.
constexpr double implicit_share = 0.5;
constexpr int removed_method = 2;         // that checkpoints of earlier versions may name
constexpr std::size_t quiet_steps = 200;  // after which methods given up may be tried again

constexpr std::size_t steps_per_estimate = 20;  // see estimate_remaining_steps()
constexpr double relaxing = 0.1;                // share of the creep that changes the stress, for log_adams
/// Contact that grows keeps the steps of all methods short: the cost of cvode_bdf may be twice that of smooth problems.
constexpr double patience = 2;

/// Solves of cvode_bdf over some decades of time, its start included, as in the examples.
double implicit_cost(double decades, double tolerance) {
  return (60 + 45 * decades) * std::pow(1e-3 / tolerance, 1.0 / 7);
}

}  // namespace

AutoIntegrator::AutoIntegrator(System& system, const IntegratorOptions& options)
    : system_(system),
      options_(options),
      method_(options.linear_solver == LinearSolver::tangent ? Method::tangent : Method::log_adams),
      current_(make(method_)) {}

std::unique_ptr<Integrator> AutoIntegrator::make(Method method) const {
  IntegratorOptions options = options_;
  if (method == Method::krylov) options.tolerance *= implicit_share;
  options.linear_solver = method == Method::tangent ? LinearSolver::tangent : LinearSolver::krylov;
  return make_integrator(is_functional(method) ? describe(method) : "cvode_bdf", system_, options);
}

const char* AutoIntegrator::describe(Method method) {
  switch (method) {
    case Method::krylov:
      return "cvode_bdf";
    case Method::tangent:
      return "cvode_bdf with linear_solver = \"tangent\"";
    case Method::cvode_adams:
      return "cvode_adams";
    case Method::log_adams:
      return "log_adams";
  }
  return "";
}

void AutoIntegrator::initialize(double t, std::span<const double> y, double step) {
  current_->initialize(t, y, step);
  starting_ = true;
  begin_watch(t);
}

void AutoIntegrator::choose_functional(double t_limit) {
  if (chosen_ || method_ != Method::log_adams) return;
  const double stable = system_.stable_step(time(), state());
  if (!(stable < t_limit - time())) return;  // what creeps until then changes little
  std::optional<double> share;
  try {
    share = relaxing_share(system_, time(), state(), stable);
  } catch (const RecoverableError&) {
    return;  // the step will tell
  }
  chosen_ = share.has_value();
  if (share && *share < relaxing) go_on_with(Method::cvode_adams, current_->next_step());
}

void AutoIntegrator::go_on_with(Method method, double step) {
  const double t = time();
  const std::vector<double> y(state().begin(), state().end());
  before_ = counters();
  current_.reset();  // its memory is needed for the next
  current_ = make(method);
  method_ = method;
  current_->initialize(t, y, step);
}

void AutoIntegrator::begin_watch(double loads_since) {
  remaining_step_estimate_.begin(loads_since);
  last_estimate_ = time();
  steps_with_method_ = 0;
  recent_.clear();
  trouble_ = false;
}

StepReport AutoIntegrator::step(double t_limit) {
  // Not right after the step that showed it: interpolate() has needed the integrator until now.
  if (trouble_) {
    const std::optional<Method> wanted = std::exchange(wanted_, std::nullopt);
    change_to(wanted ? *wanted : choose(), reason_, !wanted && !is_functional(method_));
  }
  for (;;) {
    try {
      if (starting_) choose_functional(t_limit);
      starting_ = false;
      const StepReport report = current_->step(t_limit);
      failure_.clear();
      watch(report, t_limit);
      return report;
    } catch (const SolverError& error) {
      given_up_.insert(method_);
      if (failure_.empty()) failure_ = error.what();
      const Method next = choose();
      if (next == method_)
        throw SolverError(
            fmt::format("auto: {}{}", failure_, failure_ == error.what() ? "" : " Other methods fail too."));
      change_to(next, error.what(), !is_functional(method_));
    }
  }
}

void AutoIntegrator::watch(const StepReport& report, double t_limit) {
  last_step_ = report.step;
  if (++steps_with_method_ == quiet_steps) given_up_.clear();
  if (is_functional(method_) && steps_with_method_ % steps_per_estimate == 0) estimate_remaining_steps(t_limit);
  if (trouble_) return;
  recent_.push_back(
      {current_->counters().convergence_failures, system_.counters().jacobian_products, report.error_estimate});
  if (recent_.size() <= window) return;
  const std::int64_t failures = recent_.back().failures - recent_.front().failures;
  const double products = static_cast<double>(recent_.back().products - recent_.front().products) / window;
  recent_.pop_front();
  const bool may_take_tangent =
      method_ == Method::krylov && !given_up_.contains(Method::tangent) && system_.newton_solver() != nullptr;
  const auto is_small = [](const Observation& step) { return step.error < error_of_short_steps; };
  if (may_take_tangent && failures >= failures_of_short_steps && std::ranges::all_of(recent_, is_small))
    return change_later(
        Method::tangent,
        fmt::format("iterations that failed {} times, and not the errors, limit the {} steps before t = "
                    "{:.6g}",
                    failures, window, report.time));
  trouble_ = failures > (method_ == Method::tangent ? max_failures_of_tangent : max_failures);
  if (!trouble_ && may_take_tangent && products > max_mean_products && steps_with_method_ >= min_steps_before_tangent)
    return change_later(Method::tangent,
                        fmt::format("{:.2g} Jacobian products per step at t = {:.6g}", products, report.time));
  if (!trouble_) return;
  reason_ = fmt::format("iterations failed {} times in the {} steps before t = {:.6g}", failures, window, report.time);
  given_up_.insert(method_);
}

void AutoIntegrator::change_later(Method method, std::string reason) {
  trouble_ = true;
  wanted_ = method;
  reason_ = std::move(reason);
}

void AutoIntegrator::estimate_remaining_steps(double t_limit) {
  // Yielding may bound each step, which says nothing of how long the law stays stiff.
  if (const double end = system_.end_of_segment(); std::isfinite(end)) t_limit = std::max(t_limit, end);
  if (!(time() < t_limit) || std::isinf(t_limit)) return;
  remaining_step_estimate_.add(time(), (time() - last_estimate_) / static_cast<double>(steps_per_estimate));
  last_estimate_ = time();
  const std::optional<double> ahead = remaining_step_estimate_.count(t_limit);
  const double cost = implicit_cost(remaining_step_estimate_.decades(t_limit), implicit_share * options_.tolerance);
  if (!ahead || *ahead < patience * cost || last_step_ < system_.stable_step(time(), state())) return;
  trouble_ = true;
  reason_ = fmt::format("from t = {:.6g} on, the former would need about {:.2g} more steps", time(), *ahead);
}

AutoIntegrator::Method AutoIntegrator::choose() const {
  const auto free = [&](Method method) { return !given_up_.contains(method); };
  if (is_functional(method_) && free(Method::krylov)) return Method::krylov;
  if (free(Method::tangent) && system_.newton_solver() != nullptr) return Method::tangent;
  return free(Method::krylov) ? Method::krylov : method_;
}

void AutoIntegrator::change_to(Method method, const std::string& reason, bool has_failed) {
  trouble_ = false;
  recent_.clear();
  steps_with_method_ = 0;
  if (method == method_) return;
  log::write(has_failed ? log::Level::warning : log::Level::info,
             fmt::format("time integration changes from {} to {}: {}", describe(method_), describe(method), reason));
  go_on_with(method, 0);
}

Integrator::Counters AutoIntegrator::counters() const {
  Counters all = current_->counters();
  all.steps += before_.steps;
  all.rejected_steps += before_.rejected_steps;
  all.convergence_failures += before_.convergence_failures;
  return all;
}

RestartPoint AutoIntegrator::save() const {
  RestartPoint point = current_->save();
  point.memory.save("auto", *this, saved_members);
  point.memory.save("auto.given_up", std::vector<Method>(given_up_.begin(), given_up_.end()));
  point.memory.save("auto.loads_since", remaining_step_estimate_.begin());
  return point;
}

void AutoIntegrator::restore(const RestartPoint& point) {
  point.memory.restore("auto", *this, saved_members);
  if (static_cast<int>(method_) == removed_method) method_ = Method::krylov;
  std::vector<Method> given_up;
  point.memory.restore("auto.given_up", given_up);
  given_up_ = {given_up.begin(), given_up.end()};
  current_ = make(method_);
  current_->restore(point);
  begin_watch(point.memory.at("auto.loads_since").at(0));
}

}  // namespace creepcontact::ode
