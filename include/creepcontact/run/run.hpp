#pragma once
/// A whole run: model, time loop, results.

#include <cstdint>
#include <string>
#include <vector>

#include "creepcontact/config/config.hpp"

namespace creepcontact::run {

/// Told of the course of a run.
class RunObserver {
 public:
  virtual ~RunObserver() = default;
  /// After every accepted step.
  virtual void step(double time, std::int64_t steps, std::int64_t elastic_solves) = 0;
  /// A message goes to the log next.
  virtual void before_message() = 0;
};

struct RunOptions {
  std::string output;               ///< directory; empty: the configuration's
  bool resume = false;              ///< go on from checkpoint.h5 of the directory
  RunObserver* observer = nullptr;  ///< must outlive the run
  /// File for a row of every contact iteration (time,contact_solve,set_change,iteration,method,residual,active);
  /// empty: none
  std::string log_contact = {};
};

struct RunResult {
  int exit_status = 0;
  std::string message;                   ///< why it ended early, or that nothing was left to do
  std::string report = {};               ///< lines for people on what was done and what it cost
  std::vector<std::string> advice = {};  ///< a sentence or two for each thing that was off
};

/// Runs a configuration and writes its results (history.csv, steps.csv, summary.json, fields, checkpoint.h5).
/// SIGINT and SIGTERM end it after the step under way, with a checkpoint (exit status 130). A solver that gives up ends
/// it with exit status 4; what was computed is kept.
/// It prints nothing (warnings and progress go to the log) and uses as many threads as OpenMP is set to.
/// @throws Error for what is found before the time loop (configuration 2, mesh or model 3)
RunResult run(const config::Config& config, const RunOptions& options);

}  // namespace creepcontact::run
