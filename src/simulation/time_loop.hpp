#pragma once
/// The time loop of a run: integrator, outputs, breakpoints, checkpoints.

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "creepcontact/simulation/creep_rate.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "results.hpp"

namespace creepcontact::simulation {

class TimeLoop {
 public:
  enum class End { completed, interrupted };

  /// @param resume  start from the checkpoint in the directory
  TimeLoop(const config::Config& config, CreepRate& system, Stopwatch& watch, const std::filesystem::path& directory,
           bool resume, bool quiet);

  /// @throws SolverError if the run cannot go on; what was computed is on disk, a checkpoint too
  End run();

  double time() const { return time_; }
  /// False if the run failed before its first output.
  bool has_output() const { return has_output_; }
  ode::Integrator::Counters integrator_counters() const;
  ode::System::Counters system_counters() const;
  const Results& results() const { return *results_; }
  /// Called after every output time (the summary is kept up to date with it).
  std::function<void()> after_output;

 private:
  void output(double t, std::span<const double> y);
  void integrate(const Interrupt& interrupt);
  void elastic_history(const Interrupt& interrupt);
  void write_checkpoint();
  void restore();

  const config::Config& config_;
  CreepRate& system_;
  Stopwatch& watch_;
  std::filesystem::path checkpoint_;
  std::string fingerprint_;
  std::unique_ptr<ode::Integrator> integrator_;
  std::unique_ptr<Results> results_;
  Progress progress_;
  double time_ = 0;
  bool has_output_ = false;
  double first_step_ = 0;
  std::vector<double> state_;                    // where the integration starts; then of output times
  std::map<std::string, std::int64_t> earlier_;  // counters of the runs before an interruption
  std::chrono::steady_clock::time_point last_checkpoint_ = std::chrono::steady_clock::now();
};

}  // namespace creepcontact::simulation
