#include <algorithm>
#include <iostream>
#include <iterator>

#include "command.hpp"
#include "creepcontact/base/cores.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/cli/processes.hpp"
#include "creepcontact/config/reader.hpp"
#include "creepcontact/results/criteria.hpp"
#include "creepcontact/run/report.hpp"
#include "creepcontact/run/run.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "run_progress.hpp"
#include "thread_settings.hpp"

namespace creepcontact::cli {

namespace po = boost::program_options;

namespace {

constexpr int criterion_not_met = 5;  // exit status

/// @param settings  of the command, before those of the user
int run_with(const std::vector<std::string>& settings, const Command& self, const Arguments& arguments) {
  run::RunOptions options;
  int threads = 0;
  bool quiet = false, verbose = false, strict = false;
  CommandLine line(self);
  add_overrides(line);
  line.add_options()("output,o", po::value(&options.output)->value_name("DIR"),
                     "directory of the results, instead of output.directory in the configuration");
  line.add_options()("threads,j", po::value(&threads)->value_name("N"),
                     "number of threads (default: the number of cores)");
  line.add_options()("resume", po::bool_switch(&options.resume),
                     "continue from the checkpoint in the output directory");
  line.add_options()("log-contact", po::value(&options.log_contact)->value_name("FILE.csv"),
                     "write the iterations of the contact solver to this file, one row per iteration");
  line.add_options()("strict", po::bool_switch(&strict),
                     "end with the exit status 5 if a criterion is not met or could not be judged");
  line.add_options()("verbose,v", po::bool_switch(&verbose),
                     "at the end, also report steps, solves, accuracy, time and memory");
  line.add_options()("quiet,q", po::bool_switch(&quiet), "print only warnings and errors");
  add_trust(line);
  if (!line.parse(arguments, "CONFIG.toml")) return 0;
  if (line.has("threads")) line.require_within("threads", threads, cores());

  options.processes = Processes::of_run();
  config::Config config;
  together(*options.processes.team, [&] {
    std::vector<std::string> all = settings;
    std::ranges::copy(overrides(line), std::back_inserter(all));
    config = config::read(line.positional(), run::vocabulary(), all);
  });
  config.mesh.trust_geometry = line.has(trust_option);
  ThreadChoice choice(threads);
  if (quiet && Processes::is_first()) log::set_level(log::Level::warning);
  quiet = quiet || !Processes::is_first();
  RunProgress progress(config.time.output, quiet, choice);
  options.observers = {&progress};
  const run::Summary result = run::run(config, options);
  if (!Processes::is_first()) return result.exit_status;
  if (!result.message.empty()) {
    if (result.exit_status != 0) {
      std::cerr << "error: " << result.message << '\n';
    } else if (!quiet) {
      std::cout << result.message << '\n';
    }
  }
  if (!quiet) {
    std::cout << run::report(result) << (verbose ? run::details(result) : "");
    for (const std::string& advice : result.advice) log::warning("{}", advice);
  }
  if (result.exit_status != 0 || !strict) return result.exit_status;
  for (const auto& [name, criterion] : result.results.criteria)
    if (!criterion.met.value_or(false)) std::cerr << "error: " << results::criterion_line(name, criterion) << '\n';
  return std::ranges::all_of(result.results.criteria, [](const auto& one) { return one.second.met.value_or(false); })
             ? 0
             : criterion_not_met;
}

}  // namespace

int run(const Command& self, const Arguments& arguments) {
  return run_with({}, self, arguments);
}

int heat_alone(const Command& self, const Arguments& arguments) {
  return run_with({"heat.alone = true"}, self, arguments);
}

}  // namespace creepcontact::cli
