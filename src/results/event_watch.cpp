#include "creepcontact/results/event_watch.hpp"

#include <cmath>

#include "creepcontact/base/log.hpp"

namespace creepcontact::results {
EventWatch::EventWatch(const config::Config& config, std::span<const std::unique_ptr<Probe>> probes)
    : events_(config.events), times_(config.events.size()) {
  for (const config::Event& event : events_) conditions_.emplace_back(event.when.name, config.probes, probes);
}

bool EventWatch::holds(std::size_t event, std::span<const double> values, double time) const {
  const double value = conditions_[event].value(values, time);
  return value != 0 && !std::isnan(value);
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
