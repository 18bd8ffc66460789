#include "auto_integrator.hpp"

#include <fmt/format.h>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"

namespace creepcontact::ode {
namespace {

constexpr std::size_t window = 30;         // steps looked back on
constexpr std::int64_t most_failures = 6;  // of the iterations in so many steps: a kink of a load costs some
constexpr std::int64_t most_stages = 40;   // of rkc2 in a step on average, some ten times the solves of an implicit one
constexpr double most_stable_steps = 300;  // in a step, for rkc2 to take over: 25 stages

/// Of the tolerance, for rkc2: its errors add up where rates are graded, to four tolerances at 1e-3 and seven at 1e-4.
constexpr double stabilized_share = 0.2;
constexpr std::size_t quiet_steps = 200;  // after which methods given up may be tried again

}  // namespace

AutoIntegrator::AutoIntegrator(System& system, const IntegratorOptions& options)
    : system_(system),
      options_(options),
      method_(options.linear_solver == LinearSolver::tangent ? Method::tangent : Method::krylov),
      current_(make(method_)) {}

std::unique_ptr<Integrator> AutoIntegrator::make(Method method) const {
  IntegratorOptions options = options_;
  if (method == Method::stabilized) options.tolerance *= stabilized_share;
  options.linear_solver = method == Method::tangent ? LinearSolver::tangent : LinearSolver::krylov;
  return make_integrator(method == Method::stabilized ? "rkc2" : "cvode_bdf", system_, options);
}

const char* AutoIntegrator::describe(Method method) {
  switch (method) {
    case Method::krylov:
      return "cvode_bdf";
    case Method::tangent:
      return "cvode_bdf with linear_solver = \"tangent\"";
    case Method::stabilized:
      return "rkc2";
  }
  return "";
}

void AutoIntegrator::initialize(double t, std::span<const double> y, double step) {
  current_->initialize(t, y, step);
  recent_.clear();
  trouble_ = false;
}

StepReport AutoIntegrator::step(double t_limit) {
  // Not right after the step that showed it: interpolate() has needed the integrator until now.
  if (trouble_) change_to(choose(last_step_), reason_);
  for (;;) {
    try {
      const StepReport report = current_->step(t_limit);
      failure_.clear();
      watch(report);
      return report;
    } catch (const SolverError& error) {
      given_up_.insert(method_);
      if (failure_.empty()) failure_ = error.what();
      const Method next = choose(last_step_ > 0 ? last_step_ : t_limit - time());
      if (next == method_)
        throw SolverError(
            fmt::format("auto: {}{}", failure_, failure_ == error.what() ? "" : " Other methods fail too."));
      change_to(next, error.what());
    }
  }
}

void AutoIntegrator::watch(const StepReport& report) {
  last_step_ = report.step;
  if (++steps_with_method_ == quiet_steps) given_up_.clear();
  recent_.push_back({current_->counters().convergence_failures, system_.counters().rate_evaluations});
  if (recent_.size() <= window) return;
  const std::int64_t failures = recent_.back().failures - recent_.front().failures;
  const std::int64_t stages = (recent_.back().evaluations - recent_.front().evaluations) / std::int64_t{window};
  recent_.pop_front();
  trouble_ = method_ == Method::stabilized ? stages > most_stages : failures > most_failures;
  if (!trouble_) return;
  reason_ = method_ == Method::stabilized
                ? fmt::format("{} stages a step at t = {:.6g}", stages, report.time)
                : fmt::format("its iterations failed {} times in the {} steps before t = {:.6g}", failures, window,
                              report.time);
  given_up_.insert(method_);
}

AutoIntegrator::Method AutoIntegrator::choose(double step) {
  const auto free = [&](Method method) { return !given_up_.contains(method); };
  const bool moderate = step <= most_stable_steps * system_.stable_step(time(), state());
  if (free(Method::stabilized) && moderate) return Method::stabilized;
  if (free(Method::tangent) && system_.offers_tangent()) return Method::tangent;
  if (free(Method::krylov)) return Method::krylov;
  return free(Method::stabilized) && method_ != Method::stabilized ? Method::stabilized : method_;
}

void AutoIntegrator::change_to(Method method, const std::string& reason) {
  trouble_ = false;
  recent_.clear();
  steps_with_method_ = 0;
  if (method == method_) return;
  log::warning("time integration: {} is left for {}: {}", describe(method_), describe(method), reason);
  const double t = time();
  const std::vector<double> y(state().begin(), state().end());
  before_ = counters();
  current_ = make(method);
  method_ = method;
  current_->initialize(t, y, 0);
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
  std::vector<double>& methods = point.memory["methods"];  // the present one, then those given up
  methods.push_back(static_cast<double>(method_));
  for (const Method method : given_up_) methods.push_back(static_cast<double>(method));
  return point;
}

void AutoIntegrator::restore(const RestartPoint& point) {
  const std::vector<double>& methods = point.memory.at("methods");
  method_ = static_cast<Method>(static_cast<int>(methods.at(0)));
  given_up_.clear();
  for (std::size_t i = 1; i < methods.size(); ++i) given_up_.insert(static_cast<Method>(static_cast<int>(methods[i])));
  current_ = make(method_);
  current_->restore(point);
  recent_.clear();
  trouble_ = false;
}

}  // namespace creepcontact::ode
