#include "condition_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace creepcontact::run {
namespace {

/// Brackets the instant at which a condition begins to hold by states of the step.
class Search {
 public:
  Search(double from, double to, double resolution, ConditionState at_end, const ConditionAt& at,
         const WouldHold& would_hold)
      : at_(at), would_hold_(would_hold), width_(resolution * (to - from)), before_(from), after_(to), last_guess_(to) {
    add(to, std::move(at_end));
  }

  double run() {
    for (int halvings = 1, next_halvings = 1; is_long();) {
      for (int i = 0; i < halvings && is_long(); ++i) look_at(middle());
      const double length = after_ - before_;
      for (int i = 0; i < max_guesses && is_long() && !known_.empty(); ++i) look_at(guess());
      halvings = 0;
      if (after_ - before_ <= length / 4) continue;
      halvings = next_halvings;  // the values are not smooth here
      next_halvings *= 2;
    }
    return after_;
  }

 private:
  static constexpr int max_guesses = 2;        // until the interval must be a quarter
  static constexpr std::size_t max_known = 4;  // as many values as a cubic has

  struct Known {
    double time;
    std::vector<double> values;
  };

  double middle() const { return before_ + (after_ - before_) / 2; }
  /// False where there are no numbers between its ends, too.
  bool is_long() const { return after_ - before_ > width_ && middle() > before_ && middle() < after_; }
  void look_at(double t) {
    ConditionState there = at_(t);
    (there.holds ? after_ : before_) = t;
    add(t, std::move(there));
  }

  /// The values nearest to the instant are kept.
  void add(double t, ConditionState state) {
    if (state.values.empty()) return;
    known_.push_back({t, std::move(state.values)});
    if (known_.size() <= max_known) return;
    const auto distance = [&](const Known& known) { return std::abs(known.time - (before_ + after_) / 2); };
    known_.erase(std::ranges::max_element(known_, {}, distance));
  }

  /// The polynomial through what is known (Lagrange).
  std::vector<double> values_at(double t) const {
    std::vector<double> sum(known_.front().values.size(), 0.0);
    for (std::size_t i = 0; i < known_.size(); ++i) {
      double weight = 1;
      for (std::size_t j = 0; j < known_.size(); ++j)
        if (j != i) weight *= (t - known_[j].time) / (known_[i].time - known_[j].time);
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += weight * known_[i].values[k];
    }
    return sum;
  }

  /// Within the bracket, and to that side of the instant by polynomials where the bracket is longer.
  double guess() {
    double before = before_, after = after_;
    while (after - before > width_ / 8) {
      const double middle = before + (after - before) / 2;
      if (middle <= before || middle >= after) break;
      (would_hold_(middle, values_at(middle)) ? after : before) = middle;
    }
    // So far is the polynomial off, judged by its last guess.
    constexpr double safety = 1e-2;
    const double margin = std::max(width_ / 4, safety * std::abs(after - std::exchange(last_guess_, after)));
    const double t = after_ - after > before - before_ ? after + margin : before - margin;
    return std::clamp(t, before_ + width_ / 4, after_ - width_ / 4);
  }

  const ConditionAt& at_;
  const WouldHold& would_hold_;
  double width_, before_, after_, last_guess_;
  std::vector<Known> known_;
};

}  // namespace

double first_time(double from, double to, double resolution, ConditionState at_end, const ConditionAt& at,
                  const WouldHold& would_hold) {
  return Search(from, to, resolution, std::move(at_end), at, would_hold).run();
}

std::optional<double> find_conditions(double from, double to, const ViewAt& view_at, const NearEnd& near_end,
                                      const ObserverList& observers) {
  struct Found {
    double time;
    Observer* observer;
    std::size_t number;
  };
  std::vector<Found> all;
  bool stops = false;
  std::optional<StepView> at_end;  // of all observers, until another state is evaluated
  bool is_exact = !near_end;
  for (Observer* observer : observers.all()) {
    if (!at_end) at_end.emplace(is_exact ? view_at(to) : near_end());
    std::vector<std::size_t> numbers = observer->conditions(*at_end);
    if (numbers.empty()) continue;
    if (!is_exact) {
      at_end.emplace(view_at(to));
      numbers = observer->conditions(*at_end);
    }
    const auto state_in = [&](std::size_t number, StepView& view) -> ConditionState {
      std::vector<double> values = observer->values(number, view);
      const bool holds =
          values.empty() ? observer->holds(number, view) : observer->would_hold(number, view.time(), values);
      return {holds, std::move(values)};
    };
    std::vector<ConditionState> states;
    states.reserve(numbers.size());
    for (const std::size_t number : numbers) states.push_back(state_in(number, *at_end));
    at_end.reset();
    double stop = to;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const std::size_t number = numbers[i];
      const double time = first_time(
          from, to, observer->resolution(), std::move(states[i]),
          [&](double t) {
            StepView view = view_at(t);
            return state_in(number, view);
          },
          [&](double t, std::span<const double> values) { return observer->would_hold(number, t, values); });
      all.push_back({time, observer, number});
      if (!observer->stops(number)) continue;
      stops = true;
      stop = std::min(stop, time);
    }
    to = stop;  // nothing happens after it
    is_exact = is_exact || stops;
  }
  std::ranges::stable_sort(all, {}, &Found::time);
  for (const Found& found : all) {
    if (found.time > to) break;
    StepView view = view_at(found.time);
    found.observer->happened(found.number, view);
  }
  return stops ? std::optional(to) : std::nullopt;
}

}  // namespace creepcontact::run
