#pragma once
/// A whole run: model, time loop, results.

#include <string>

#include "creepcontact/config/config.hpp"

namespace creepcontact::run {

struct RunOptions {
  std::string output;   ///< directory; empty: the configuration's
  int threads = 0;      ///< 0: OpenMP's default
  bool resume = false;  ///< go on from checkpoint.h5 of the directory
  bool quiet = false;   ///< errors and warnings only
  /// File for a row of every contact iteration (time,contact_solve,set_change,iteration,method,residual,active);
  /// empty: none
  std::string log_contact = {};
};

struct RunResult {
  int exit_status = 0;
  std::string message;
};

/// Runs a configuration and writes its results (history.csv, steps.csv, summary.json, fields, checkpoint.h5).
/// SIGINT and SIGTERM end it after the step under way, with a checkpoint (exit status 130). A solver that gives up ends
/// it with exit status 4; what was computed is kept.
/// @throws Error for what is found before the time loop (configuration 2, mesh or model 3)
RunResult run(const config::Config& config, const RunOptions& options);

}  // namespace creepcontact::run
