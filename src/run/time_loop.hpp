#pragma once
/// The time loop of a run: integrator, outputs, breakpoints, checkpoints.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "checkpoints.hpp"
#include "creepcontact/base/run_counters.hpp"
#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/model/data_range_monitor.hpp"
#include "creepcontact/model/table_range_monitor.hpp"
#include "creepcontact/platform/interrupt.hpp"
#include "creepcontact/results/damage_monitor.hpp"
#include "creepcontact/results/event_watch.hpp"
#include "creepcontact/results/outcome.hpp"
#include "creepcontact/results/probe_record.hpp"
#include "creepcontact/results/results.hpp"
#include "creepcontact/run/run.hpp"
#include "cycles.hpp"
#include "event_search.hpp"
#include "guarded_steps.hpp"
#include "preload_watch.hpp"
#include "run_report.hpp"
#include "step_extremes.hpp"

namespace creepcontact::run {

class TimeLoop {
 public:
  /// interrupted: by a signal, between two steps or, through the contact iterations of the solver, within one
  enum class End { completed, ruptured, interrupted };

  /// @param distribution  of the model; must outlive the object @param system  of its own part
  /// @param resume  start from the checkpoint in the directory @param observer  may be null
  /// @param probes  those of the configuration
  TimeLoop(const config::Config& config, const model::Model& model, const creep::Distribution& distribution,
           creep::CreepSystem& system, std::vector<std::unique_ptr<results::Probe>> probes, Stopwatch& watch,
           const std::filesystem::path& directory, bool resume, RunObserver* observer = nullptr);

  /// @throws SolverError if the run cannot go on; what was computed is on disk, a checkpoint too
  End run();

  double time() const { return time_; }
  /// False if the run failed before its first output.
  bool has_output() const { return has_output_; }
  /// Whether there is a checkpoint on disk.
  bool may_be_resumed() const { return checkpoints_.exist(); }
  RunCounters counters() const;
  const results::Results& results() const { return *results_; }
  const results::DamageMonitor& life() const { return life_; }
  /// Largest contact::friction_kappa() at the start and the end; nullopt without friction.
  std::optional<double> friction_kappa() const { return friction_kappa_; }
  const results::Outcome& outcome() const { return outcome_; }
  const results::ProbeRecord& probe_record() const { return probe_record_; }
  const results::SmallStrainMonitor& small_strains() const { return small_strains_; }
  const results::EventWatch& events() const { return *events_; }
  /// Null without time.cycle.
  const Cycles* cycles() const { return cycles_ ? &*cycles_ : nullptr; }
  /// Why a completed run ended before its time; empty: it did not.
  std::string end_message() const { return cycles_ && stopped_ ? cycles_->end_message() : ""; }
  /// Of the steps since the start or the resume.
  const StepStatistics& step_statistics() const { return step_statistics_; }
  /// Of the end of the run: what to say of contacts that few elements resolve.
  const std::vector<std::string>& narrow_contacts() const { return narrow_contacts_; }
  /// Of the end of the run, see results::equilibrium_residual().
  std::optional<double> equilibrium_residual() const { return equilibrium_residual_; }
  bool resumed() const { return earlier_ != RunCounters{}; }
  /// The integrator at work.
  std::string method() const { return integrator_ ? integrator_->method() : ""; }
  /// Called after every output time (the summary is kept up to date with it).
  std::function<void()> after_output;

 private:
  void output(double t, std::span<const double> y);
  /// All output times up to time_, those before it interpolated. @param breakpoint  a segment of the loads ends here
  /// @returns false if the run has gone back to before a jump over cycles
  bool outputs_of_step(bool breakpoint);
  /// Between two cycles: jumps over some, or begins the next one.
  void begin_cycle();
  /// At a breakpoint, before the loads change. @returns false if the run has gone back to before a jump over cycles
  bool end_of_segment();
  /// Starts the integration anew from state_ at a time that is not that of the integrator.
  void continue_at(double t);
  /// In a cycle after a jump: goes back if something has happened that the jump may have passed over.
  /// @returns true if it has gone back
  bool gone_back_for_event();
  void go_back_before_jump();
  void record_step(const ode::StepReport& report, const RunCounters& work);
  void write_held_steps();
  /// The state at time_, of an accepted step or after the loads have jumped there, counts for the extremes of the run.
  void see_extremes(std::span<const double> y);
  /// Unless the cycle under way may be rejected.
  void keep_extremes();
  void begin_segment();
  /// Damage has reached its end within the last step: takes the time back to where, with the results up to there.
  bool ruptured(double begin_of_step);
  /// Finds the events in (from, to]. @returns true if one of them stops the run: time_ is then that of the stop
  bool stopped_within(double from, double to, const StateAt& state_at);
  /// The same for the last step of the integrator, up to time_, with the results up to a stop.
  bool stopped_in_step(double begin);
  /// Finds the events that hold at time_, such as after a jump of the loads. @returns as stopped_within()
  bool stopped_at_once(std::span<const double> y);
  void report_rupture(double time, const creep::CreepSystem::Extreme& where);
  void integrate(const platform::Interrupt& interrupt);
  void see_uniqueness(const creep::Equilibrium& at);
  /// Where yielding bounds the next step.
  double longest_step_end() const;
  /// Ends of the present segment of the loads; infinite where there is none.
  model::StepGuard::Segment segment() const;
  /// The first breakpoint after time_.
  void find_next_breakpoint();
  void add_breakpoint(double t);
  /// Where the next step has to end at the latest. A jump that nobody knew of becomes a breakpoint.
  double end_of_step();
  void elastic_history(const platform::Interrupt& interrupt);
  /// True if a run that is resumed from here computes the same.
  bool at_restart_point() const {
    return (!integrator_ || integrator_->at_restart_point()) && (!cycles_ || cycles_->may_be_resumed());
  }
  io::Checkpoint checkpoint() const;
  /// True if a process asks for the end of the run. Collective.
  bool interrupted(const platform::Interrupt& interrupt) const;
  /// Waits for the field files that are being written. Collective. @throws Error if the disk is full
  void wait_for_fields();
  /// Waits for the field files that are being written. If they fail, the run is resumed from before them: from kept_.
  void finish_fields();
  /// Keeps a copy where the next step may lead to no restart point.
  void keep_restart_point();
  /// The newest restart point to disk.
  void write_checkpoint();

  const config::Config& config_;
  const model::Model& model_;
  const creep::Distribution& distribution_;
  creep::CreepSystem& system_;
  WholeState whole_;
  Stopwatch& watch_;
  Checkpoints checkpoints_;
  std::unique_ptr<ode::Integrator> integrator_;
  std::vector<std::unique_ptr<results::Probe>> probes_;
  std::unique_ptr<results::Results> results_;
  RunObserver* observer_;
  results::DamageMonitor life_;
  results::Outcome outcome_;
  results::ProbeRecord probe_record_;
  results::SmallStrainMonitor small_strains_;
  std::optional<results::EventWatch> events_;  // of probes_
  std::optional<Cycles> cycles_;               // likewise
  std::optional<GuardedSteps> guard_;          // of integrators with a state
  std::optional<PreloadWatch> preloads_;
  std::optional<StepExtremes> extremes_;  // likewise
  std::optional<double> friction_kappa_;
  model::TableRangeMonitor table_ranges_;
  model::DataRangeMonitor data_ranges_;
  StepStatistics step_statistics_;
  std::vector<std::string> narrow_contacts_;
  std::optional<double> equilibrium_residual_;
  double time_ = 0;
  bool has_output_ = false;
  bool ruptured_ = false;
  bool stopped_ = false;                        // by an event, or because the cycles repeat
  bool restarts_ = false;                       // with the state that the end of a cycle has changed
  double last_output_ = -1;                     // time of the last row
  bool settled_ = false;                        // integrated up to time_, and all results up to there are on disk
  std::optional<io::Checkpoint> resumed_;       // until the integration has begun
  std::optional<io::Checkpoint> kept_;          // the last restart point, if steps have left it
  std::optional<io::Checkpoint> after_fields_;  // a later one, for when the field files under way are written
  std::vector<double> state_;                   // of output times
  /// A step in a cycle after a jump, which may be rejected.
  struct HeldStep {
    ode::StepReport report;
    RunCounters work;
    std::int64_t n_active_contacts = 0;
  };
  std::vector<HeldStep> held_steps_;
  RunCounters earlier_;  // counters of the runs before an interruption
  std::vector<double>::const_iterator next_output_;
  std::vector<double> breakpoints_;  // those of the model, and jumps found since
  std::size_t next_break_ = 0;       // index
};

}  // namespace creepcontact::run
