#include "time_loop.hpp"

#include <algorithm>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/io/checkpoint.hpp"
#include "fingerprint.hpp"

namespace creepcontact::simulation {
namespace {

constexpr double seconds_between_checkpoints = 30;

ode::IntegratorOptions integrator_options(const config::Time& time) {
  ode::IntegratorOptions options;
  options.tolerance = time.tolerance;
  options.step = time.step.value_or(0.0);
  options.step_factor = time.step_factor;
  options.beta = time.beta;
  options.inner_tolerance = time.inner_tolerance;
  options.inner_anderson = time.inner_anderson;
  options.residual_correction = time.residual_correction;
  options.end_time = time.end;
  return options;
}

}  // namespace

TimeLoop::TimeLoop(const config::Config& config, CreepRate& system, Stopwatch& watch,
                   const std::filesystem::path& directory, bool resume, bool quiet)
    : config_(config),
      system_(system),
      watch_(watch),
      checkpoint_(directory / "checkpoint.h5"),
      fingerprint_(fingerprint(system.elasticity().model())),
      progress_(config.time.output, quiet),
      state_(system.size(), 0.0) {
  io::Continuation continuation;
  if (resume) {
    restore();
    continuation = {.resume = true, .last_time = time_};
  }
  results_ = std::make_unique<Results>(config, directory, system.elasticity(), continuation);
  if (system.size() > 0)
    integrator_ = ode::make_integrator(config.time.integrator, system, integrator_options(config.time));
}

void TimeLoop::restore() {
  const io::Checkpoint checkpoint = io::read_checkpoint(checkpoint_);
  if (checkpoint.fingerprint != fingerprint_ || checkpoint.state.size() != state_.size())
    throw ConfigError(
        fmt::format("{}: the checkpoint is of another model than '{}'; give the configuration it was "
                    "written with, or run without --resume",
                    checkpoint_.string(), config_.file.string()));
  time_ = checkpoint.time;
  has_output_ = true;
  first_step_ = checkpoint.next_step;
  state_ = checkpoint.state;
  earlier_ = checkpoint.counters;
}

void TimeLoop::write_checkpoint() {
  const auto lap = watch_.lap(Part::output);
  io::Checkpoint checkpoint;
  checkpoint.fingerprint = fingerprint_;
  checkpoint.time = time_;
  if (integrator_) {
    checkpoint.next_step = integrator_->next_step();
    checkpoint.state.assign(integrator_->state().begin(), integrator_->state().end());
  }
  const ode::System::Counters of_system = system_counters();
  const ode::Integrator::Counters of_integrator = integrator_counters();
  checkpoint.counters = {{"steps", of_integrator.steps},
                         {"rejected_steps", of_integrator.rejected_steps},
                         {"convergence_failures", of_integrator.convergence_failures},
                         {"rate_evaluations", of_system.rate_evaluations},
                         {"jacobian_products", of_system.jacobian_products},
                         {"elastic_solves", of_system.elastic_solves},
                         {"contact_solves", of_system.contact_solves},
                         {"schwarz_iterations", of_system.schwarz_iterations},
                         {"factorizations", of_system.factorizations}};
  io::write_checkpoint(checkpoint_, checkpoint);
  last_checkpoint_ = std::chrono::steady_clock::now();
}

ode::Integrator::Counters TimeLoop::integrator_counters() const {
  ode::Integrator::Counters result = integrator_ ? integrator_->counters() : ode::Integrator::Counters{};
  const auto earlier = [&](const char* name) { return earlier_.contains(name) ? earlier_.at(name) : 0; };
  result.steps += earlier("steps");
  result.rejected_steps += earlier("rejected_steps");
  result.convergence_failures += earlier("convergence_failures");
  return result;
}

ode::System::Counters TimeLoop::system_counters() const {
  ode::System::Counters result = system_.counters();
  const auto earlier = [&](const char* name) { return earlier_.contains(name) ? earlier_.at(name) : 0; };
  result.rate_evaluations += earlier("rate_evaluations");
  result.jacobian_products += earlier("jacobian_products");
  result.elastic_solves += earlier("elastic_solves");
  result.contact_solves += earlier("contact_solves");
  result.schwarz_iterations += earlier("schwarz_iterations");
  result.factorizations += earlier("factorizations");
  return result;
}

void TimeLoop::output(double t, std::span<const double> y) {
  system_.equilibrium(t, y);
  {
    const auto lap = watch_.lap(Part::output);
    results_->output(Snapshot(system_.elasticity(), system_.layout(), t, y));
    has_output_ = true;
  }
  if (after_output) after_output();
}

TimeLoop::End TimeLoop::run() {
  const Interrupt interrupt;
  try {
    if (time_ == 0 && earlier_.empty()) output(0, state_);
    if (integrator_)
      integrate(interrupt);
    else
      elastic_history(interrupt);
  } catch (const ode::RecoverableError& error) {
    write_checkpoint();
    throw SolverError(error.what());
  } catch (const Error&) {
    write_checkpoint();
    throw;
  }
  write_checkpoint();
  return time_ >= config_.time.end ? End::completed : End::interrupted;
}

void TimeLoop::integrate(const Interrupt& interrupt) {
  const double end = config_.time.end;
  const std::vector<double>& outputs = config_.time.output;
  const std::vector<double>& breakpoints = system_.elasticity().model().breakpoints;
  auto next_output = std::upper_bound(outputs.begin(), outputs.end(), time_);
  auto next_break = std::upper_bound(breakpoints.begin(), breakpoints.end(), time_);
  integrator_->initialize(time_, std::vector<double>(state_), first_step_);
  while (time_ < end && !interrupt.requested()) {
    const double stop = next_break != breakpoints.end() ? *next_break : end;
    const bool may_pass_outputs = integrator_->interpolates() || next_output == outputs.end();
    const ode::System::Counters before = system_.counters();
    const ode::StepReport report = integrator_->step(may_pass_outputs ? stop : std::min(stop, *next_output));
    results_->step(report, before, system_.counters());
    time_ = integrator_->time();
    progress_.step(time_, integrator_counters().steps, system_counters().elastic_solves);
    for (; next_output != outputs.end() && *next_output <= time_; ++next_output) {
      if (*next_output == time_) {
        output(time_, integrator_->state());
      } else {
        integrator_->interpolate(*next_output, state_);
        output(*next_output, state_);
      }
    }
    if (next_break != breakpoints.end() && time_ >= *next_break) {
      ++next_break;
      integrator_->initialize(time_, std::vector<double>(integrator_->state().begin(), integrator_->state().end()));
    }
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - last_checkpoint_).count() >
        seconds_between_checkpoints)
      write_checkpoint();
  }
  progress_.clear();
}

void TimeLoop::elastic_history(const Interrupt& interrupt) {
  for (const double t : config_.time.output) {
    if (t <= time_) continue;
    if (interrupt.requested()) return;
    output(t, state_);
    time_ = t;
    system_.accept(t, state_);
  }
  time_ = config_.time.end;
}

}  // namespace creepcontact::simulation
