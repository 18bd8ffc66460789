#pragma once
/// The times at which the steps of a run end or are looked into: breakpoints and output times.

#include <vector>

#include "creepcontact/model/step_guard.hpp"

namespace creepcontact::run {

/// Knows which breakpoint and which output time come next.
class Schedule {
 public:
  /// @param outputs  ascending; must outlive the object @param breakpoints  ascending @param end  of the run
  Schedule(const std::vector<double>& outputs, std::vector<double> breakpoints, double end)
      : outputs_(outputs), breakpoints_(std::move(breakpoints)), end_(end) {}

  /// The run is at time t, and what comes next is after it. Outputs before t have been made.
  void begin(double t);
  /// Sets the time for the breakpoints alone: the run has passed one, or goes on from another time.
  void go_to(double t);
  /// Does nothing if it is known. @param t  after the present time
  void add_breakpoint(double t);

  /// The next breakpoint; the end of the run if there is none.
  double next_stop() const { return has_breakpoint() ? breakpoints_[next_breakpoint_] : end_; }
  bool is_breakpoint(double t) const;
  /// The segment of the loads around the present time t; infinite where it has no end.
  model::StepGuard::Segment segment(double t) const;
  /// The next output time; infinity: there is none.
  double next_output() const;
  void pass_output() { ++next_output_; }
  double end() const { return end_; }

 private:
  bool has_breakpoint() const { return next_breakpoint_ < breakpoints_.size(); }

  const std::vector<double>& outputs_;
  std::vector<double> breakpoints_;
  double end_;
  std::size_t next_output_ = 0, next_breakpoint_ = 0;
};

}  // namespace creepcontact::run
