#pragma once
/// Performs the runs of a study, compares them with the reference, and writes study.csv and study.md.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/config/study.hpp"
#include "creepcontact/config/vocabulary.hpp"
#include "creepcontact/plot/run_plots.hpp"

namespace creepcontact::study {

/// A run that is made in this process.
struct RunCall {
  std::filesystem::path base;
  std::vector<std::string> overrides;
  std::filesystem::path output, log;  ///< directory of its results, and file for its messages
  bool resume = false, trust_geometry = false;
};

/// Makes runs as threads of this process, `at_once` at a time, which share what they have in common.
/// @param ended  called with number and exit status of each that has ended, by one thread at a time
using RunsTogether = std::function<void(const std::vector<RunCall>& calls, std::size_t at_once,
                                        const std::function<void(std::size_t run, int exit_status)>& ended)>;

/// Options that are not part of the study file.
struct StudyOptions {
  std::filesystem::path program;    ///< started for each run: `program run CONFIG.toml ...`
  std::filesystem::path output;     ///< directory; empty: results/<name of the study> next to its file
  int jobs = 0;                     ///< concurrent runs; 0: one per core
  bool trust_geometry = false;      ///< let .geo files run programs and write files
  std::size_t together = 16;        ///< samples of [random] that are computed at a time in this process; 1: none
  RunsTogether make_together = {};  ///< null: every run is a process of its own
  /// The unit of the values of a probe, empty if it is not known; null: none are.
  std::function<std::string(const config::Probe& probe, const std::string& units)> unit_of_probe = {};
};

/// Outcome of a study.
struct StudyResult {
  int exit_status = 0;  ///< 0; 4 if no run succeeded; 130 if interrupted
  std::string message;
};

/// Each run is a separate process, those of random samples threads of this one, in <output>/runs/<name>; concurrent
/// runs share the cores as threads. Runs finished by an earlier call with the same settings, files and version are
/// kept; interrupted ones continue from their checkpoint. SIGINT, SIGTERM and SIGHUP end the current runs, each with a
/// checkpoint.
/// @param vocabulary  names that the configurations may use
/// @throws ConfigError with all errors found before the first run, or if the directory contains another study
/// @throws SolverError if the reference run does not finish
StudyResult run_study(const config::Study& study, const config::Vocabulary& vocabulary, const StudyOptions& options);

/// One of `count` parts of a study, numbered from 1.
struct Shard {
  int number = 1, count = 1;
};

/// Makes the runs of a shard that are not finished yet, and no tables. Shards may be computed at the same time, on
/// several machines with a common file system; the first one also makes the reference run.
/// @returns as run_study(), of the runs of the shard
/// @throws ConfigError as run_study(); also if another process computes this shard, or the study is divided into
/// another number of shards
StudyResult run_shard(const config::Study& study, const config::Vocabulary& vocabulary, const StudyOptions& options,
                      const Shard& shard);

/// Makes one run, unless it is finished. @param name  "run_001" or "reference"
/// @throws ConfigError as run_study(), or if there is no such run
StudyResult run_single(const config::Study& study, const config::Vocabulary& vocabulary, const StudyOptions& options,
                       const std::string& name);

/// Writes the tables and pictures of the runs that there are, and makes none. Messages name what is missing.
/// @returns exit status 0 if every run has been made, and one has succeeded; else 4
/// @throws ConfigError as run_study(); also if another process gathers
StudyResult gather_study(const config::Study& study, const config::Vocabulary& vocabulary, const StudyOptions& options);

/// A command of the shell for each run, the reference first.
std::vector<std::string> run_commands(const config::Study& study, const StudyOptions& options);

/// A script that submits the shards as an array of jobs to Slurm, and after it a job that gathers.
/// @param shards  0: a hundred, but no more than there are runs
std::string slurm_script(const config::Study& study, const StudyOptions& options, int shards);

/// True if a study was run in this directory.
bool is_study_directory(const std::filesystem::path& directory);

/// Draws `history_<probe>` of all runs in the directory of a study, with the values of the axes as legend.
/// @param options  the directory of the pictures: `plots` in that of the study, unless given
/// @returns the SVG files @throws ConfigError if no run has a history, and as plot::plot_overlay()
std::vector<std::filesystem::path> plot_study_histories(const std::filesystem::path& directory,
                                                        plot::PlotOptions options);

}  // namespace creepcontact::study
