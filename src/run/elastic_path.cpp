#include "elastic_path.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"

namespace creepcontact::run {
namespace {
constexpr double never = std::numeric_limits<double>::infinity();
constexpr int most_passed = 2000;       // states, two per breakpoint: an elastic solve each
constexpr double shortest_step = 1e-7;  // relative to the time
}  // namespace

ElasticPath::ElasticPath(creep::CreepSystem& system, const std::vector<double>& breakpoints,
                         const std::vector<double>& state, double time, Callbacks callbacks)
    : system_(system), breakpoints_(breakpoints), state_(state), time_(time), callbacks_(std::move(callbacks)) {}

bool ElasticPath::stopped_before(double t) {
  if (system_.has_friction() ? stopped_with_friction(t) : stopped_by_event(t)) return true;
  time_ = t;
  return false;
}

void ElasticPath::pass(double t) {
  if (n_passed_ < most_passed) callbacks_.passes(t);
  if (++n_passed_ == most_passed)
    log::warning(
        "the loads have more than {} breakpoints between output times: those after t = {:.6g} are not looked at, so "
        "that the largest values there are those of output times alone. Put output times where the loads are largest",
        most_passed / 2, t);
}

/// Without friction there is nothing on the way but events and extremes.
bool ElasticPath::stopped_by_event(double t) {
  double from = time_;
  for (auto jump = std::ranges::upper_bound(breakpoints_, from); from < t; ++jump) {
    const bool is_jump = jump != breakpoints_.end() && *jump <= t;
    const double to = is_jump ? *jump : t;
    system_.begin_segment(-never, is_jump ? to : never);
    if (callbacks_.stops(from, to)) return true;
    from = to;
    callbacks_.reached(to);
    if (!is_jump) break;
    pass(to);
    system_.begin_segment(to, never);
    system_.apply_preloads(to, state_);
    if (callbacks_.stops(to, to)) return true;
    if (to < t) pass(to);
  }
  begin_last_segment(t);
  return false;
}

bool ElasticPath::stopped_with_friction(double t) {
  for (auto turn = std::ranges::upper_bound(breakpoints_, time_); turn != breakpoints_.end() && *turn <= t; ++turn) {
    system_.begin_segment(last_breakpoint_before(*turn), *turn);
    if (stopped_in_slip(*turn)) return true;
    callbacks_.passes(*turn);
    system_.begin_segment(*turn, never);
    system_.apply_preloads(*turn, state_);
    system_.accept(*turn, state_);
    callbacks_.reached(*turn);
    if (callbacks_.stops(*turn, *turn)) return true;
    if (*turn < t) callbacks_.passes(*turn);
  }
  begin_last_segment(t);
  return stopped_in_slip(t);
}

bool ElasticPath::stopped_in_slip(double t) {
  double reached = system_.history().friction.time, step = t - reached;
  while (true) {
    step = std::min(step, system_.longest_step_of_friction(reached, t));
    const double to = step < t - reached ? reached + step : t;
    try {
      system_.accept(to, state_);
    } catch (const RecoverableError&) {  // loads that friction cannot hold in one step, or not at all
      step = (to - reached) / 2;
      if (!(step > shortest_step * t)) throw;
      continue;
    }
    if (to > reached && callbacks_.stops(reached, to)) return true;
    if (to < t) callbacks_.passes(to);
    if (to >= t) return false;
    reached = to;
    step *= 2;
  }
}

/// A result at a jump is that after it.
void ElasticPath::begin_last_segment(double t) {
  const bool is_jump = std::ranges::binary_search(breakpoints_, t);
  const auto next = std::ranges::upper_bound(breakpoints_, t);
  system_.begin_segment(is_jump ? t : last_breakpoint_before(t), next != breakpoints_.end() ? *next : never);
}

double ElasticPath::last_breakpoint_before(double t) const {
  const auto next = std::ranges::lower_bound(breakpoints_, t);
  return next != breakpoints_.begin() ? *std::prev(next) : -never;
}

}  // namespace creepcontact::run
