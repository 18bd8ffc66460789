#include "sensitive_integrator.hpp"

#include <algorithm>
#include <utility>

namespace creepcontact::run {
namespace {

const std::string vectors_name = "vectors";

}  // namespace

SensitiveIntegrator::SensitiveIntegrator(
    std::unique_ptr<Derivatives> derivatives,
    const std::function<std::unique_ptr<ode::Integrator>(ode::System&)>& make_inner)
    : of_(std::move(derivatives)),
      system_(*of_),
      inner_(make_inner(system_)),
      n_(of_->base().size()),
      whole_(of_->size(), 0.0) {}

void SensitiveIntegrator::initialize(double t, std::span<const double> y, double step) {
  if (has_stepped_) whole_ = whole_at(t);
  std::ranges::copy(y, whole_.begin());
  of_->pass_breakpoint(t, whole_);
  system_.set_scale(whole_);
  inner_->initialize(t, whole_, step);
  whole_.assign(inner_->state().begin(), inner_->state().end());
  has_stepped_ = false;
  begin_ = t;
}

ode::StepReport SensitiveIntegrator::step(double t_limit) {
  begin_ = inner_->time();
  const ode::StepReport report = inner_->step(t_limit);
  has_stepped_ = true;
  if (n_ == 0) of_->follow_loads(report.time);
  return report;
}

void SensitiveIntegrator::interpolate(double t, std::span<double> y) const {
  std::vector<double> whole(whole_.size());
  inner_->interpolate(t, whole);
  std::copy_n(whole.begin(), n_, y.begin());
}

std::vector<double> SensitiveIntegrator::whole_at(double t) const {
  if (!has_stepped_) return whole_;
  if (t == inner_->time()) return {inner_->state().begin(), inner_->state().end()};
  std::vector<double> whole(whole_.size());
  inner_->interpolate(t, whole);
  return whole;
}

std::vector<double> SensitiveIntegrator::derivatives() const {
  const std::span<const double> whole = has_stepped_ ? inner_->state() : std::span<const double>(whole_);
  return {whole.begin() + static_cast<std::ptrdiff_t>(n_), whole.end()};
}

void SensitiveIntegrator::set_derivatives(std::span<const double> derivatives) {
  std::ranges::copy(derivatives, whole_.begin() + static_cast<std::ptrdiff_t>(n_));
}

ode::RestartPoint SensitiveIntegrator::save() const {
  ode::RestartPoint point = inner_->save();
  point.state.resize(n_);  // derivatives() has the rest
  point.memory.add(vectors_name, std::exchange(point.states, {}));
  return point;
}

void SensitiveIntegrator::restore(const ode::RestartPoint& point) {
  std::ranges::copy(point.state, whole_.begin());
  has_stepped_ = false;
  begin_ = point.time;
  ode::RestartPoint whole = point;
  whole.state = whole_;
  whole.states = point.memory.part(vectors_name);
  system_.set_scale(whole_);
  inner_->restore(whole);
  of_->resume(point.time, whole_);
}

}  // namespace creepcontact::run
