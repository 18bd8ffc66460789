#include "creepcontact/heat/history.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "creepcontact/ode/implicit_integrator.hpp"

namespace creepcontact::heat {
namespace {

constexpr double for_steps = 0.5,
                 for_output = 0.3;  // of the tolerance: for the root mean square, and the largest error

constexpr double for_repetition = 0.1;  // of the tolerance: what is left of a start that is not periodic
constexpr double same_boundary = 1e-9;  // of a period

constexpr double first_step = 1e-3;  // of what is left: at most what IDA begins with

struct Node {
  double t = 0;
  std::vector<double> value, rate;
};

/// Cubic Hermite polynomial between two nodes.
double between(const Node& a, const Node& b, std::size_t i, double t) {
  const double h = b.t - a.t, s = (t - a.t) / h;
  const double r = 1 - s;
  return r * r * (1 + 2 * s) * a.value[i] + s * s * (3 - 2 * s) * b.value[i] +
         s * r * h * (r * a.rate[i] - s * b.rate[i]);
}

/// The steps of one segment, thinned.
class Segment {
 public:
  Segment(double allowed, History& into) : allowed_(allowed), into_(into) {}

  void add(Node node) {
    if (kept_.empty()) {
      kept_.push_back(std::move(node));
      return;
    }
    waiting_.push_back(std::move(node));
    if (waiting_.size() > 1 && !is_reproduced()) {
      Node last = std::move(waiting_.back());
      waiting_.pop_back();
      kept_.push_back(std::move(waiting_.back()));
      waiting_.clear();
      waiting_.push_back(std::move(last));
    }
  }

  void finish() {
    if (!waiting_.empty()) kept_.push_back(std::move(waiting_.back()));
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      Node& node = kept_[i];
      if (i == 0 && !into_.times.empty()) {  // the end of the segment before
        into_.rates_after.back() = node.rate;
        if (into_.values.back() == node.value) continue;
        node.t = std::nextafter(node.t, std::numeric_limits<double>::infinity());  // given temperatures jump
      }
      into_.times.push_back(node.t);
      into_.values.push_back(std::move(node.value));
      into_.rates_before.push_back(node.rate);
      into_.rates_after.push_back(std::move(node.rate));
    }
  }

 private:
  /// Whether the last node and the last kept one reproduce all between them.
  bool is_reproduced() const {
    const Node &a = kept_.back(), &b = waiting_.back();
    for (std::size_t k = 0; k + 1 < waiting_.size(); ++k)
      for (std::size_t i = 0; i < a.value.size(); ++i)
        if (!(std::abs(between(a, b, i, waiting_[k].t) - waiting_[k].value[i]) <= allowed_)) return false;
    return true;
  }

  double allowed_;
  History& into_;
  std::vector<Node> kept_, waiting_;
};

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// The ends of periods within a run, and whether temperatures have become periodic there.
class Periods {
 public:
  explicit Periods(const HistoryOptions& options) : allowed_(for_repetition * options.tolerance), end_(options.end) {
    if (options.repeats) all_ = *options.repeats;
  }

  /// The kinks with the ends of periods, each time once.
  std::vector<double> with_ends(const std::vector<double>& kinks) {
    std::vector<double> all = kinks;
    if (!(all_.period > 0)) return all;
    const double close = same_boundary * all_.period;
    const auto count = static_cast<std::int64_t>((end_ - close - all_.from) / all_.period) + 1;
    for (std::int64_t k = 0; k < count; ++k) {
      const double t = all_.from + static_cast<double>(k) * all_.period;
      if (!(t > close) || !(t < end_ - close)) continue;
      const auto near = std::ranges::lower_bound(kinks, t - close);
      const bool is_kink = near != kinks.end() && *near <= t + close;
      ends_.push_back(is_kink ? *near : t);
      if (!is_kink) all.push_back(t);
    }
    std::ranges::sort(all);
    return all;
  }

  /// Where given temperatures jump within the period, nothing is known to repeat: the moment of a jump is rounded.
  bool are_reached(double t, const std::vector<double>& y, History& history) {
    if (!std::ranges::binary_search(ends_, t)) return false;
    const double change = before_.empty() ? std::numeric_limits<double>::infinity() : largest_difference(before_, y);
    const double ratio = change / last_change_;  // of a series that is geometric in the end
    const double left =
        ratio < 1 ? change * std::max(1.0, ratio / (1 - ratio)) : std::numeric_limits<double>::infinity();
    const bool reached = change == 0 || left <= allowed_;
    last_change_ = change;
    if (!reached) {
      before_ = y;
      return false;
    }
    const auto first = std::ranges::lower_bound(history.times, t - 1.5 * all_.period);
    for (auto at = first; at + 1 < history.times.end(); ++at)
      if (at[1] == std::nextafter(at[0], at[1])) return false;
    history.values.back() = before_;
    history.period = all_.period;
    return true;
  }

 private:
  double allowed_, end_;
  Repeats all_ = {};
  std::vector<double> ends_, before_;
  double last_change_ = std::numeric_limits<double>::infinity();
};

}  // namespace

History integrate(Conduction& problem, std::vector<double> start, const HistoryOptions& options) {
  History result;
  if (!(options.end > 0)) {
    result.times = {0};
    result.rates_before = result.rates_after = {std::vector<double>(start.size(), 0.0)};
    result.values = {std::move(start)};
    return result;
  }
  ode::ImplicitIntegrator integrator(problem, for_steps * options.tolerance);
  result.kinks = options.kinks;
  Periods periods(options);
  std::vector<double> ends = periods.with_ends(options.kinks);
  ends.push_back(options.end);
  std::vector<double> y = std::move(start), rate(y.size());
  double t = 0;
  for (const double end : ends) {
    // A function that jumps has its value after the jump at the beginning, and before it at the end.
    const double begin = t > 0 ? std::nextafter(t, end) : t, last = end < options.end ? std::nextafter(end, t) : end;
    problem.set_segment(begin, last);
    problem.make_consistent(begin, y, rate);
    integrator.start(begin, y, rate);
    Segment segment(for_output * options.tolerance, result);
    segment.add({t, y, rate});
    while (integrator.time() < last) {
      double to = last;
      if (options.end_of_step) {
        const double t_now = integrator.time(), step = integrator.next_step();
        const double next = std::min(last, t_now + (step > 0 ? step : first_step * (last - t_now)));
        const double limit = options.end_of_step(t_now, next, begin, last);
        if (limit > t_now && limit < next) to = limit;
      }
      integrator.step(to);
      segment.add({integrator.time() >= last ? end : integrator.time(),
                   {integrator.state().begin(), integrator.state().end()},
                   {integrator.rate().begin(), integrator.rate().end()}});
    }
    segment.finish();
    result.n_steps += integrator.n_steps();
    y.assign(integrator.state().begin(), integrator.state().end());
    t = end;
    if (periods.are_reached(t, y, result)) break;
  }
  return result;
}

}  // namespace creepcontact::heat
