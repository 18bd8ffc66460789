#include "condition_search.hpp"

#include <algorithm>
#include <vector>

namespace creepcontact::run {

double first_time(double from, double to, double resolution, const std::function<bool(double)>& holds) {
  double before = from, after = to;
  while (after - before > resolution * (to - from)) {
    const double middle = before + (after - before) / 2;
    if (middle <= before || middle >= after) break;
    (holds(middle) ? after : before) = middle;
  }
  return after;
}

std::optional<double> find_conditions(double from, double to, const ViewAt& view_at, const ObserverList& observers) {
  struct Found {
    double time;
    Observer* observer;
    std::size_t number;
  };
  std::vector<Found> all;
  bool stops = false;
  std::optional<StepView> at_end;  // of all observers, until the search evaluates another state
  for (Observer* observer : observers.all()) {
    if (!at_end) at_end.emplace(view_at(to));
    const std::vector<std::size_t> numbers = observer->conditions(*at_end);
    double stop = to;
    for (const std::size_t number : numbers) {
      const double time = first_time(from, to, observer->resolution(), [&](double t) {
        StepView view = view_at(t);
        return observer->holds(number, view);
      });
      all.push_back({time, observer, number});
      if (!observer->stops(number)) continue;
      stops = true;
      stop = std::min(stop, time);
    }
    to = stop;  // nothing happens after it
    if (!numbers.empty()) at_end.reset();
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
