#include "course_events.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "repetition.hpp"

namespace creepcontact::model {
namespace {

constexpr double most_repeated = 3e5;        // jumps and kinks of a period of its own, in all repetitions
constexpr double most_repeated_turns = 1e5;  // as stops; beyond, bounds on steps
constexpr double most_turns_of_found_period = 1000;
constexpr int samples_of_cycle = 2039;  // of one that differs from the others

/// Whether a vibration has kinks or jumps in each period, by a close look at some pieces of it.
bool has_kinks(const Course& course, Interval dense, double gap) {
  constexpr int windows = 5, samples = 4093;
  constexpr double turns_in_window = 20, share = 0.3;
  const double width = std::min(turns_in_window * gap, dense.high - dense.low);
  int n_kinky = 0;
  for (int i = 0; i < windows; ++i) {
    const double begin = dense.low + (dense.high - dense.low - width) * (i + 0.37) / windows;
    const Discontinuities found = find_discontinuities(course, {begin, begin + width}, samples);
    const double n = static_cast<double>(found.jumps.size() + found.kinks.size());
    n_kinky += found.too_many || n > share * width / gap ? 1 : 0;
  }
  return n_kinky > windows / 2;
}

CourseEvents searched(const Course& course, Interval over, int samples, double turn_evaluations) {
  constexpr int fewest_samples = 1021;
  CourseEvents result;
  Extrema extrema = find_extrema(course, over, turn_evaluations, samples);
  std::vector<Interval> clear{over};  // without vibrations
  for (const Interval& dense : extrema.dense) {
    const double gap = (dense.high - dense.low) / std::max(extrema.count, 1.0);
    result.too_many = result.too_many || has_kinks(course, dense, gap);
    const double until = clear.back().high;
    clear.back().high = std::min(dense.low + gap, until);
    clear.push_back({std::max(dense.high - gap, clear.back().high), until});
  }
  for (const Interval& part : clear) {
    const double share = (part.high - part.low) / (over.high - over.low);
    if (!(share > 1e-9)) continue;
    const int n = std::max(fewest_samples, static_cast<int>(share * samples));
    const Discontinuities found = find_discontinuities(course, part, std::min(n, samples));
    result.too_many = result.too_many || found.too_many;
    result.jumps.insert(result.jumps.end(), found.jumps.begin(), found.jumps.end());
    result.kinks.insert(result.kinks.end(), found.kinks.begin(), found.kinks.end());
  }
  result.jumps.insert(result.jumps.end(), extrema.jumps.begin(), extrema.jumps.end());
  result.turns = std::move(extrema.turns);
  result.limits = std::move(extrema.limits);
  result.n_turns = extrema.count;
  result.vibrates = extrema.count > static_cast<double>(most_turns);
  return result;
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// All but whether there are too many.
void append(CourseEvents& to, const CourseEvents& more) {
  append(to.jumps, more.jumps);
  append(to.kinks, more.kinks);
  append(to.turns, more.turns);
  append(to.limits, more.limits);
  to.n_turns += more.n_turns;
  to.vibrates = to.vibrates || more.vibrates;
}

/// Where a jump in the pattern is in another cycle, to the last bit.
double repeated_jump(const Course& course, double time) {
  constexpr double near = 1e-10;
  const double reach = near * time;
  return jump_between(course, time - reach, time + reach).value_or(time);
}

/// What one cycle has, in all others that are like it.
void repeat(const Course& course, const CourseEvents& pattern, const Repetition& cycles, double end,
            double stops_at_turns, CourseEvents& into) {
  const double period = cycles.period();
  const double n = static_cast<double>(cycles.count());
  const bool stops = static_cast<double>(pattern.turns.size()) * n <= stops_at_turns;
  for (std::int64_t k = 1; k <= cycles.count(); ++k) {
    if (cycles.differs(k)) continue;
    const double shift = static_cast<double>(k - cycles.pattern()) * period;
    for (const double t : pattern.jumps)
      if (t + shift < end) into.jumps.push_back(k == cycles.pattern() ? t : repeated_jump(course, t + shift));
    for (const double t : pattern.kinks)
      if (t + shift < end) into.kinks.push_back(t + shift);
    for (const Turn& turn : pattern.turns)
      if (stops && turn.time + shift < end) into.turns.push_back({turn.time + shift, turn.error});
  }
  into.n_turns += pattern.n_turns * n;
  double shortest = HUGE_VAL;
  for (const StepLimit& limit : pattern.limits) shortest = std::min(shortest, limit.step);
  into.vibrates = into.vibrates || pattern.vibrates || !stops;
  if (shortest < HUGE_VAL) into.limits.push_back({period, end, shortest});
}

CourseEvents without_cycle(const Course& course, double end, const SearchEffort& effort);

std::optional<CourseEvents> repeated(const Course& course, double end, double period, const SearchEffort& effort,
                                     bool is_declared) {
  const auto cycles = Repetition::find(course, end, period, effort.comparisons, effort.fewest_phases);
  if (!cycles) return std::nullopt;
  CourseEvents result, pattern;
  if (cycles->pattern() == 1) {  // the first two together
    const CourseEvents both = is_declared ? without_cycle(course, 2 * period, effort)
                                          : searched(course, {0, 2 * period}, effort.samples, effort.turn_evaluations);
    result.too_many = both.too_many;
    const double second = period * (1 - 1e-11);
    const auto share = [&](const std::vector<double>& from, std::vector<double>& first, std::vector<double>& later) {
      for (const double t : from) (t < second ? first : later).push_back(t);
    };
    share(both.jumps, result.jumps, pattern.jumps);
    share(both.kinks, result.kinks, pattern.kinks);
    for (const Turn& turn : both.turns) (turn.time < second ? result : pattern).turns.push_back(turn);
    for (const StepLimit& limit : both.limits) {
      if (limit.begin < second) result.limits.push_back(limit);
      if (limit.end > second) pattern.limits.push_back(limit);
    }
    pattern.n_turns = 0.5 * both.n_turns;
    pattern.vibrates = both.vibrates;
  } else {
    result = searched(course, {0, period}, effort.samples, effort.turn_evaluations);
    const double begin = static_cast<double>(cycles->pattern()) * period;
    pattern = searched(course, {begin, begin + period}, effort.samples, effort.turn_evaluations);
    result.too_many = result.too_many || pattern.too_many;
  }
  const double n = static_cast<double>(cycles->count());
  if (!is_declared && static_cast<double>(pattern.jumps.size() + pattern.kinks.size()) * n > most_repeated)
    result.too_many = true;
  if (result.too_many) return result;
  repeat(course, pattern, *cycles, end, is_declared ? most_repeated_turns : most_turns_of_found_period, result);
  for (const Interval& other : cycles->different(end)) {
    const double width = other.high - other.low;
    const int samples = samples_of_cycle * static_cast<int>(std::ceil(width / period - 1e-6));
    const double beside = 1e-3 * period;  // a jump at the end belongs to the next cycle, which may be like the others
    append(result, searched(course, {other.low - beside, std::min(other.high + beside, end)},
                            std::min(samples, effort.samples), effort.turn_evaluations));
  }
  return result;
}

/// Ends of intervals are found in both of them.
void keep_distinct(std::vector<double>& times, double error) {
  std::ranges::sort(times);
  const auto same = [error](double a, double b) { return b <= a * (1 + error); };
  times.erase(std::unique(times.begin(), times.end(), same), times.end());
}

CourseEvents without_cycle(const Course& course, double end, const SearchEffort& effort) {
  CourseEvents result = searched(course, {0, end}, effort.samples, effort.turn_evaluations);
  if (!result.too_many) return result;
  if (const auto period = find_period(course, end); period && end / *period <= most_repeated)
    if (auto of_period = repeated(course, end, *period, effort, false); of_period && !of_period->too_many)
      return *of_period;
  return result;
}

}  // namespace

CourseEvents find_events(const Course& course, double end, std::optional<double> cycle, const SearchEffort& effort) {
  std::optional<CourseEvents> result;
  if (cycle && 2 * *cycle < end) result = repeated(course, end, *cycle, effort, true);
  if (!result) result = without_cycle(course, end, effort);
  keep_distinct(result->jumps, 1e-15);
  keep_distinct(result->kinks, 1e-11);
  return *result;
}

}  // namespace creepcontact::model
