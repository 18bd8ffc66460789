#include "creepcontact/results/event_watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "creepcontact/base/log.hpp"

namespace creepcontact::results {
EventWatch::EventWatch(const config::Config& config, std::span<const std::unique_ptr<Probe>> probes)
    : events_(config.events), times_(config.events.size()) {
  for (const config::Event& event : events_) conditions_.emplace_back(event.when.name, config.probes, probes);
}

bool EventWatch::is_waiting() const {
  return std::ranges::any_of(times_, [](const std::optional<double>& time) { return !time; });
}

namespace {
bool is_true(double value) {
  return value != 0 && !std::isnan(value);
}
}  // namespace

bool EventWatch::holds(std::size_t event, Snapshot& snapshot) const {
  return is_true(conditions_[event].value(snapshot));
}

bool EventWatch::holds(std::size_t event, std::span<const double> probe_values, double time) const {
  return is_true(conditions_[event].value(probe_values, time));
}

std::vector<std::size_t> EventWatch::holding(Snapshot& snapshot) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < events_.size(); ++i)
    if (!times_[i] && holds(i, snapshot)) found.push_back(i);
  return found;
}

void EventWatch::happened(std::size_t event, double time) {
  times_[event] = time;
  log::info("event '{}' at t = {:.10g}: {}{}", events_[event].name, time, events_[event].when.name,
            events_[event].stop ? "; the run ends here" : "");
}

void EventWatch::fill(io::Summary& summary) const {
  for (std::size_t i = 0; i < events_.size(); ++i) summary.events[events_[i].name] = times_[i];
}

void EventWatch::save(creep::Memory& memory) const {
  memory.save("events.times", times_);
}

void EventWatch::restore(const creep::Memory& memory) {
  std::vector<std::optional<double>> times;
  memory.restore("events.times", times);
  if (times.size() == times_.size()) times_ = std::move(times);
}

}  // namespace creepcontact::results
