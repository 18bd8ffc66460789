#pragma once
/// Observers of events: their conditions on probes.

#include "creepcontact/results/event_watch.hpp"
#include "observers.hpp"

namespace creepcontact::run {

class EventConditions : public Observer {
 public:
  std::vector<std::size_t> conditions(StepView& view) const final {
    std::vector<std::size_t> waiting;
    for (std::size_t event = 0; event < watch_.n_events(); ++event)
      if (is_waiting(event)) waiting.push_back(event);
    std::erase_if(waiting, [&](std::size_t event) { return !holds(event, view); });
    return waiting;
  }
  std::vector<double> values(std::size_t event, StepView& view) const final {
    return view.with_snapshot([&](results::Snapshot& snapshot) { return watch_.values(event, snapshot); });
  }
  bool would_hold(std::size_t event, double time, std::span<const double> values) const final {
    return watch_.holds(event, values, time);
  }

 protected:
  explicit EventConditions(const RunContext& context) : watch_(context.config, context.observed.probes()) {}

  virtual bool is_waiting(std::size_t event) const = 0;
  const results::EventWatch& watch() const { return watch_; }
  results::EventWatch& watch() { return watch_; }

 private:
  results::EventWatch watch_;
};

}  // namespace creepcontact::run
