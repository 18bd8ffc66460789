#include "event_search.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace creepcontact::run {

double first_time(double from, double to, const std::function<bool(double)>& holds) {
  constexpr double near = 1e-10;  // of the interval
  double before = from, after = to;
  while (after - before > near * (to - from)) {
    const double middle = before + (after - before) / 2;
    if (middle <= before || middle >= after) break;
    (holds(middle) ? after : before) = middle;
  }
  return after;
}

std::optional<double> find_events(double from, double to, const StateAt& state_at, WholeState& whole,
                                  results::EventWatch& events, RunObserver* observer) {
  if (!events.is_waiting()) return std::nullopt;
  const std::vector<double> holding = whole.look(to, state_at(to), [&](results::Snapshot& at_end) {
    const std::vector<std::size_t> numbers = events.holding(at_end);
    return std::vector<double>(numbers.begin(), numbers.end());
  });
  std::vector<std::pair<double, std::size_t>> found;
  for (const double number : holding) {
    const auto event = static_cast<std::size_t>(number);
    const auto holds = [&](double t) {
      return !whole
                  .look(t, state_at(t),
                        [&](results::Snapshot& snapshot) {
                          return std::vector<double>(events.holds(event, snapshot) ? 1 : 0);
                        })
                  .empty();
    };
    found.emplace_back(first_time(from, to, holds), event);
  }
  std::ranges::sort(found);
  std::optional<double> stop;
  for (const auto& [time, event] : found) {
    if (stop && time > *stop) break;
    if (observer != nullptr) observer->before_message();
    events.happened(event, time);
    if (events.stops(event)) stop = time;
  }
  return stop;
}

}  // namespace creepcontact::run
