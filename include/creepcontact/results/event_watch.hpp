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

  /// True while an event has not happened: there is something to look for.
  bool is_waiting() const;
  /// Numbers of the events that have not happened and whose condition holds in this state. Evaluates only the probes
  /// that these conditions name. Collective.
  std::vector<std::size_t> holding(Snapshot& snapshot) const;
  /// True if the condition of one event holds in this state.
  bool holds(std::size_t event, Snapshot& snapshot) const;
  /// holds() for given values of all probes.
  bool holds(std::size_t event, std::span<const double> probe_values, double time) const;
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
