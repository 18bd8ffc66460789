#pragma once
/// Events: the first times at which conditions on probes hold.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/creep/equilibrium_solver.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/results/probe_expression.hpp"

namespace creepcontact::results {

/// Evaluates conditions and keeps the times; where to look is up to the caller.
class EventWatch {
 public:
  /// @param probes  of the configuration; they must outlive the object
  EventWatch(const config::Config& config, std::span<const std::unique_ptr<Probe>> probes);

  std::size_t n_events() const { return events_.size(); }
  /// True while the event has not happened.
  bool is_waiting(std::size_t event) const { return !times_[event]; }
  /// The probes that the condition of an event names, zeros for the others. Collective.
  std::vector<double> values(std::size_t event, Snapshot& snapshot) const {
    return conditions_[event].values(snapshot);
  }
  /// True if the condition holds with such values at a time.
  bool holds(std::size_t event, std::span<const double> values, double time) const;
  /// Keeps the time and reports it in the log.
  void happened(std::size_t event, double time);
  bool stops(std::size_t event) const { return events_[event].stop; }

  void fill(io::Summary& summary) const;
  void save(creep::Memory& memory) const;
  /// Does nothing if the memory has another number of events.
  void restore(const creep::Memory& memory);

 private:
  const std::vector<config::Event>& events_;
  std::vector<ProbeExpression> conditions_;
  std::vector<std::optional<double>> times_;
};

}  // namespace creepcontact::results
