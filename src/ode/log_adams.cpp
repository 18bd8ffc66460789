#include "log_adams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "first_step.hpp"
#include "step_failures.hpp"

namespace creepcontact::ode {

namespace {
/// Part of the tolerance. The estimates do not include the errors of the steps before, and steps are long: with it the
/// error of the results is that of the other methods.
constexpr double adams_share = 0.1;
/// Factor by which first_step() may be exceeded: it is meant for order 1, and the second step has order 2 already.
constexpr double first_stretch = 5;
constexpr double adams_target_error = 0.5;
constexpr double adams_largest_growth = 2, adams_smallest_cut = 0.9, adams_largest_cut = 0.1;
constexpr double growth_ahead = 1.2;  // of the steps that a higher order would make, to stay stable
constexpr double adams_failure_cut = 0.5;
constexpr double adams_tiny_error = 1e-10;
constexpr double adams_smallest_step = 1e-12;  // relative to the time
constexpr int attempts_of_high_order = 3;
/// In half stable steps, for each order. Beyond, it may be unstable: what its error estimates miss, or see late.
constexpr std::array<double, LogAdamsHistory::max_order + 1> stiffness_limit{0, HUGE_VAL, HUGE_VAL, 3};
constexpr int stable_steps = 4;  // for which the stable step is taken to stay
constexpr double first_power = 0, power_step = 0.25, smallest_power = 0, largest_power = 1.25;
constexpr double better_power = 0.9;  // its error, relative to that of the present one
/// Smaller errors are rounding where the rate is constant, which power 0 integrates exactly.
constexpr double worth_a_change = 1e-3;
/// A step cut by a limit to less than this part of the last one adds nothing to the history but rounding errors, if
/// the rate at its end is the one that the polynomial predicts.
constexpr double adams_sliver = 1e-3, sliver_error = 0.1;
}  // namespace

LogAdams::LogAdams(System& system, const IntegratorOptions& options)
    : system_(system), options_(options), norm_(system.team(), adams_share * options.tolerance) {
  for (auto* vector : {&state_, &next_state_, &extrapolated_, &change_, &work_}) vector->resize(system.size());
}

void LogAdams::initialize(double t, std::span<const double> y, double step) {
  norm_.set_scale(system_.scale());
  clock_.start(t);
  std::ranges::copy(y, state_.begin());
  begin_ = t;
  last_step_ = 0;
  proposal_ = step;
  order_ = 1;
  climbing_ = true;
  stable_age_ = 0;
  power_direction_ = 1;
  history_ = {.clock = {.origin = t, .unit = 0}, .power = first_power, .count = 1};
  phi_.resize(1, std::vector<double>(state_.size()));
  at_start(*this, t, [&] {
    system_.rate(t, state_, phi_[0]);
    history_.clock.unit = 0.5 * system_.stable_step(t, state_);
  });
}

void LogAdams::begin(double t_limit) {
  const double latest = latest_first_end(time(), t_limit, options_.end_time);
  const double stable = 2 * history_.clock.unit;
  history_.clock.unit = std::min(history_.clock.unit, latest - time());
  if (!(history_.clock.unit > 0)) history_.clock.unit = latest - time();
  if (proposal_ > 0) return;
  const Start start{*this, time(), state_, phi_[0], latest, stable};
  proposal_ =
      first_stretch * ode::first_step(system_, norm_, start, next_state_, change_, counters_.convergence_failures);
}

StepReport LogAdams::step(double t_limit) {
  if (!(t_limit > time())) throw std::invalid_argument(fmt::format("limit {} is not after t = {}", t_limit, time()));
  if (last_step_ == 0) begin(t_limit);
  double h = proposal_;
  StepAttempts attempts(*this, counters_);
  attempts.begin(h);
  for (;; attempts.again(h)) {
    const StepClock::Target target = clock_.target(h, t_limit, StepClock::stretch);
    const double no_time_passes = adams_smallest_step * std::abs(time());
    if (attempts.count() == 1 && target.step < h && target.step < adams_sliver * std::max(last_step_, no_time_passes)) {
      const double error = target.step > no_time_passes && last_step_ > 0 ? error_of(target) : 0;
      if (error <= sliver_error) {
        slide(target);
        return {.time = time(), .step = target.step, .order = order_, .error_estimate = error};
      }
      // The rate changes suddenly: what is known of it does not help.
      initialize(time(), std::vector<double>(state_), target.step);
      return step(t_limit);
    }
    const double s = history_.clock.at(target.time);
    try {
      predict(s);
      correct(target, s);
      Errors of = errors();
      if (of.own <= 1) {
        const StepReport report{.time = target.time, .step = target.step, .order = order_, .error_estimate = of.own};
        const bool cut = target.step < h;  // by the limit: says nothing about the step that accuracy allows
        accept(target, s);
        // Of equal steps, cut by one limit after another, the errors within a vibration cancel as long as order and
        // power stay.
        if (!cut) follow_power(of);
        const double growth = cut ? order_of_cut_step(of) : choose_order(of);
        const double next = target.step * std::min(growth, attempts.count() > 1 ? 1.0 : adams_largest_growth);
        proposal_ = cut ? std::max(h, next) : next;
        return report;
      }
      attempts.rejected(of.own);
      h = shortened(target.step, of);
      if (attempts.count() >= attempts_of_high_order) order_ = 1;
    } catch (const RecoverableError& failure) {
      attempts.failed(failure);
      h = adams_failure_cut * target.step;
    }
    climbing_ = false;
  }
}

double LogAdams::error_of(const StepClock::Target& target) {
  try {
    predict(history_.clock.at(target.time));
    correct(target, history_.clock.at(target.time));
    return errors().own;
  } catch (const RecoverableError&) {
    return HUGE_VAL;
  }
}

/// The nodes must not come that close.
void LogAdams::slide(const StepClock::Target& target) {
  const double s = history_.clock.at(target.time);
  add_integral(history_.dense_integrals(s), next_state_);
  Row to = history_.nodes;
  to[0] = s;
  transform(history_.moved(to, 0));
  history_.nodes = to;
  finish(target);
}

void LogAdams::finish(const StepClock::Target& target) {
  begin_ = time();
  clock_.advance(target);
  std::swap(state_, next_state_);
  ++counters_.steps;
  system_.accept(time(), state_);
  norm_.set_scale(system_.scale());
}

void LogAdams::predict(double s) {
  const auto order = static_cast<std::size_t>(order_);
  stretch_ = history_.stretch(s);
  integrals_ = history_.step_integrals(s, order_ + 2);
  for_each_piece(state_.size(), [&](std::size_t begin, std::size_t n) {
    auto predicted = piece(next_state_.data(), begin, n);
    auto rate = piece(extrapolated_.data(), begin, n);
    predicted = piece(state_.data(), begin, n);
    rate.setZero();
    for (std::size_t j = order; j-- > 0;) {  // the small terms first
      const auto term = piece(std::as_const(phi_[j]).data(), begin, n);
      predicted += integrals_[j] * stretch_[j] * term;
      rate += stretch_[j] * term;
    }
  });
}

void LogAdams::correct(const StepClock::Target& target, double s) {
  system_.rate(target.time, next_state_, change_);
  if (stable_age_ == 0) stable_ = system_.stable_step(target.time, next_state_);
  stiffness_ = 2 * target.step / stable_;
  const double weight = std::exp(history_.power * s);
  for_each_index(change_.size(), [&](std::size_t i) { change_[i] = weight * change_[i] - extrapolated_[i]; });
  if (JacobianProducts* jacobian = system_.jacobian()) {
    jacobian->precondition_once(target.time, next_state_, integrals_[static_cast<std::size_t>(order_)] * weight,
                                change_, work_);
    std::swap(change_, work_);
  }
}

double LogAdams::norm_of(const std::vector<double>& rate) const {
  return norm_([&](std::size_t begin, std::size_t n) { return piece(rate.data(), begin, n); });
}

double LogAdams::norm_with(double factor, const std::vector<double>& term) const {
  return norm_([&](std::size_t begin, std::size_t n) {
    return piece(change_.data(), begin, n) + factor * piece(term.data(), begin, n);
  });
}

/// The difference of the correctors of two successive orders.
LogAdams::Errors LogAdams::errors() const {
  const auto k = static_cast<std::size_t>(order_);
  Errors of;
  of.own = std::abs(integrals_[k] - integrals_[k - 1]) * norm_of(change_);
  if (order_ > 1) of.lower = std::abs(integrals_[k - 1] - integrals_[k - 2]) * norm_with(stretch_[k - 1], phi_[k - 1]);
  if (history_.count > order_ && order_ < LogAdamsHistory::max_order)
    of.higher = std::abs(integrals_[k + 1] - integrals_[k]) * norm_with(-stretch_[k], phi_[k]);
  return of;
}

void LogAdams::accept(const StepClock::Target& target, double s) {
  const auto k = static_cast<std::size_t>(order_);
  if (phi_.size() <= k) phi_.emplace_back(state_.size());
  for_each_piece(state_.size(), [&](std::size_t begin, std::size_t n) {
    const auto change = piece(std::as_const(change_).data(), begin, n);
    piece(next_state_.data(), begin, n) += integrals_[k] * change;
    piece(phi_[k].data(), begin, n) = change;
    for (std::size_t j = k; j-- > 0;) {
      auto phi = piece(phi_[j].data(), begin, n);
      phi = stretch_[j] * phi + piece(std::as_const(phi_[j + 1]).data(), begin, n);
    }
  });
  history_.add(s);
  history_.count = order_ + 1;
  last_step_ = target.step;
  stable_age_ = (stable_age_ + 1) % stable_steps;
  finish(target);
}

/// Tries a neighbour of the present power; one that is no better changes the direction of the next trial.
void LogAdams::follow_power(Errors& errors) {
  if (order_ < 2 || errors.own < worth_a_change) return;
  const double change = power_direction_ * power_step;
  const double power = history_.power + change;
  bool better = power >= smallest_power && power <= largest_power;
  if (better) {
    const auto k = static_cast<std::size_t>(order_);
    const LogAdamsHistory::Matrix matrix = history_.moved(history_.nodes, change);
    const Row& row = matrix[k];
    const Row integrals = history_.last_step_integrals(power, order_ + 1);
    const auto term = [&](std::size_t j, std::size_t begin, std::size_t n) {
      return row[j] * piece(std::as_const(phi_[std::min(j, k)]).data(), begin, n);
    };
    static_assert(LogAdamsHistory::max_order == 3);
    const double size = norm_([&](std::size_t begin, std::size_t n) {
      return term(0, begin, n) + term(1, begin, n) + term(2, begin, n) + term(3, begin, n);
    });
    const double other = std::abs(integrals[k] - integrals[k - 1]) * size;
    better = other < better_power * errors.own;
    if (better) {
      transform(matrix);
      history_.power = power;
      errors.own = other;
    }
  }
  if (!better) power_direction_ = -power_direction_;
}

void LogAdams::transform(const LogAdamsHistory::Matrix& matrix) {
  const auto count = static_cast<std::size_t>(history_.count);
  for_each_index(state_.size(), [&](std::size_t i) {
    Row row{};
    for (std::size_t j = 0; j < count; ++j) row[j] = phi_[j][i];
    for (std::size_t m = 0; m < count; ++m) {
      double sum = 0;
      for (std::size_t j = 0; j < count; ++j) sum += matrix[m][j] * row[j];
      phi_[m][i] = sum;
    }
  });
}

bool LogAdams::is_stable(int order, double growth) const {
  return order <= LogAdamsHistory::max_order && stiffness_ * growth <= stiffness_limit[static_cast<std::size_t>(order)];
}

/// As high as it may be: a lower one could not make a longer step. @returns the factor of the next step
double LogAdams::order_of_cut_step(const Errors& errors) {
  constexpr double small = 0.3;
  if (order_ > 1 && !is_stable(order_, 1))
    --order_;
  else if (errors.higher > 0 && errors.higher < small && is_stable(order_ + 1, growth_ahead))
    ++order_;
  return 1;
}

double LogAdams::choose_order(const Errors& errors) {
  const auto factor = [](double error, int order) {
    return std::pow(adams_target_error / std::max(error, adams_tiny_error), 1.0 / (order + 1));
  };
  const double same = factor(errors.own, order_);
  const double lower = order_ > 1 ? factor(errors.lower, order_ - 1) : 0;
  const double higher = errors.higher > 0 ? factor(errors.higher, order_ + 1) : 0;
  climbing_ = climbing_ && lower <= same && same >= 1 && is_stable(order_ + 1, adams_largest_growth);
  if (climbing_) {
    ++order_;
    return same;
  }
  if (order_ > 1 && (!is_stable(order_, 1) || (lower > same && lower >= higher))) {
    --order_;
    return lower;
  }
  if (higher > same && is_stable(order_ + 1, std::min(higher, growth_ahead))) {
    ++order_;
    return higher;
  }
  return same;
}

double LogAdams::shortened(double h, const Errors& errors) {
  double error = errors.own;
  if (order_ > 1 && errors.lower < error) {
    --order_;
    error = errors.lower;
  }
  // An error that is not a number fails the comparison, too.
  return h * (error < 1e9 ? std::clamp(std::pow(adams_target_error / error, 1.0 / (order_ + 1)), adams_largest_cut,
                                       adams_smallest_cut)
                          : adams_largest_cut);
}

void LogAdams::interpolate(double t, std::span<double> y) const {
  if (t == time()) {
    std::ranges::copy(state_, y.begin());
    return;
  }
  require_in_last_step(*this, t, begin_);
  add_integral(history_.dense_integrals(history_.clock.at(t)), y);
}

void LogAdams::add_integral(const Row& integrals, std::span<double> y) const {
  for_each_piece(y.size(), [&](std::size_t begin, std::size_t n) {
    auto result = piece(y.data(), begin, n);
    result = piece(state_.data(), begin, n);
    for (std::size_t j = 0; j < static_cast<std::size_t>(history_.count); ++j)
      result += integrals[j] * piece(phi_[j].data(), begin, n);
  });
}

RestartPoint LogAdams::save() const {
  RestartPoint point = Integrator::save();
  std::vector<double> rates;
  rates.reserve(static_cast<std::size_t>(history_.count) * state_.size());
  for (std::size_t j = 0; j < static_cast<std::size_t>(history_.count); ++j)
    rates.insert(rates.end(), phi_[j].begin(), phi_[j].end());
  point.memory.save("", *this, saved_members);
  point.memory.save("lost_time", clock_.lost());
  point.states["phi"] = std::move(rates);
  return point;
}

void LogAdams::restore(const RestartPoint& point) {
  const std::vector<double>& rates = point.states.at("phi");
  point.memory.restore("", *this, saved_members);
  clock_.start(point.time, point.memory.at("lost_time").at(0));
  norm_.set_scale(system_.scale());
  state_ = point.state;
  phi_.clear();
  for (std::size_t j = 0; j < static_cast<std::size_t>(history_.count); ++j) {
    const auto begin = rates.begin() + static_cast<std::ptrdiff_t>(j * state_.size());
    phi_.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(state_.size()));
  }
  begin_ = point.time;
  proposal_ = point.next_step;
  system_.forget_evaluations();
}

}  // namespace creepcontact::ode
