#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <iostream>

#include "command.hpp"
#include "creepcontact/base/cores.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/config/study.hpp"
#include "creepcontact/results/probe_record.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "creepcontact/study/study.hpp"
#include "runs_together.hpp"

namespace creepcontact::cli {
namespace {

constexpr int max_shards = 10'000;

/// "3/16"
study::Shard shard_in(const std::string& text) {
  study::Shard shard;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, shard.number);
  const bool has_slash = number.ec == std::errc() && number.ptr != end && *number.ptr == '/';
  const auto count = std::from_chars(has_slash ? number.ptr + 1 : end, end, shard.count);
  const bool is_whole = has_slash && count.ec == std::errc() && count.ptr == end;
  if (is_whole && shard.count >= 1 && shard.count <= max_shards && shard.number >= 1 && shard.number <= shard.count)
    return shard;
  throw ConfigError(
      fmt::format("--shard: '{}'; allowed: i/N with i from 1 to N and N from 1 to {}, --shard 3/16", text, max_shards));
}

/// Only one of these at a time says what is done.
void require_one_task(const CommandLine& line) {
  std::string first;
  for (const char* const task : {"list", "run", "shard", "gather", "slurm"}) {
    if (!line.has(task)) continue;
    if (!first.empty()) throw ConfigError(fmt::format("--{} and --{}: only one of them can be given", first, task));
    first = task;
  }
  if (line.has("shards") && !line.has("slurm"))
    throw ConfigError("--shards says into how many jobs --slurm divides the study; a single one is --shard i/N");
}

}  // namespace

int study(const Command& self, const Arguments& arguments) {
  namespace po = boost::program_options;
  study::StudyOptions options;
  std::string output, run, shard;
  int shards = 0, together = 16;
  CommandLine line(self);
  auto add = line.add_options();
  add("jobs", po::value(&options.jobs)->value_name("N"), "number of runs at a time (default: the number of cores)");
  add("together", po::value(&together)->value_name("N"),
      "samples of [random] computed together in one process, which shares mesh, factors and passes through them "
      "(default: 16; 1: each in a process of its own)");
  add("output,o", po::value(&output)->value_name("DIR"),
      "directory of the results (default: results/<name of the study> next to the study file)");
  add("list", "print one command of the shell per run, and run nothing");
  add("run", po::value(&run)->value_name("NAME"), "make this run alone, run_001 or reference, and no tables");
  add("shard", po::value(&shard)->value_name("i/N"), "make the i-th of N parts of the runs alone, and no tables");
  add("gather", "make the tables and pictures of the runs that there are, and name those that are missing");
  add("slurm", "print a script that submits the shards and the gathering to Slurm, and run nothing");
  add("shards", po::value(&shards)->value_name("N"), "with --slurm: number of shards (default: 100, or one per run)");
  add_trust(line);
  if (!line.parse(arguments, "STUDY.toml")) return 0;
  constexpr int max_jobs = 1000;
  if (line.has("jobs")) line.require_within("jobs", options.jobs, max_jobs);
  constexpr int max_together = 64;  // beyond, passes do not get cheaper
  if (line.has("together")) line.require_within("together", together, max_together);
  options.together = static_cast<std::size_t>(together);
  options.unit_of_probe = results::ProbeRecord::unit_of;
  options.make_together = runs_together(options.jobs > 0 ? options.jobs : cores());
  if (line.has("shards")) line.require_within("shards", shards, max_shards);
  require_one_task(line);
  options.output = output;
  options.trust_geometry = line.has(trust_option);
  std::error_code error;
  options.program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) throw SolverError("cannot find the program's own file: /proc/self/exe: " + error.message());

  const config::Study study = config::read_study(line.positional());
  if (line.has("list")) {
    for (const std::string& command : study::run_commands(study, options)) std::cout << command << '\n';
    return 0;
  }
  if (line.has("slurm")) {
    std::cout << study::slurm_script(study, options, shards);
    return 0;
  }
  const config::Vocabulary vocabulary = run::vocabulary();
  const study::StudyResult result = line.has("run")      ? study::run_single(study, vocabulary, options, run)
                                    : line.has("shard")  ? study::run_shard(study, vocabulary, options, shard_in(shard))
                                    : line.has("gather") ? study::gather_study(study, vocabulary, options)
                                                         : study::run_study(study, vocabulary, options);
  (result.exit_status == 0 ? std::cout : std::cerr << "error: ") << result.message << '\n';
  return result.exit_status;
}

}  // namespace creepcontact::cli
