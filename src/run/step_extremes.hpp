#pragma once
/// Extremes of a run between its output times: what the ends of the steps and the breakpoints show.

#include <memory>
#include <span>
#include <vector>

#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/results/outcome.hpp"
#include "creepcontact/results/probe_record.hpp"
#include "creepcontact/results/probes.hpp"
#include "creepcontact/results/small_strain_monitor.hpp"
#include "whole_state.hpp"

namespace creepcontact::run {

/// Takes contact forces, stresses, probes and the largest strain from evaluations that the steps have made, so that
/// nothing is solved for them. Their errors are within the tolerance of the steps. Calls are collective.
class StepExtremes {
 public:
  /// @param whole, probes, outcome, record, strains  must outlive the object @param tolerance  relative, of the steps
  StepExtremes(WholeState& whole, std::span<const std::unique_ptr<results::Probe>> probes, results::Outcome& outcome,
               results::ProbeRecord& record, results::SmallStrainMonitor& strains, double tolerance);

  /// A state; it counts with keep().
  /// @param at  the evaluation at t, on the state there or within the tolerance of it
  void see(double t, const creep::Evaluation& at);
  /// The same for a state that no step needs. Where it has no equilibrium, a warning says so.
  void see_between(double t, std::span<const double> y);
  /// All that has been seen is part of the run.
  void keep();
  /// What has been seen since keep() is no part of the run: it goes back.
  void drop() { seen_.clear(); }

 private:
  WholeState& whole_;
  std::span<const std::unique_ptr<results::Probe>> probes_;
  results::Outcome& outcome_;
  results::ProbeRecord& record_;
  results::SmallStrainMonitor& strains_;
  double tolerance_;
  std::vector<results::StepValues> seen_;
};

}  // namespace creepcontact::run
