#include <filesystem>
#include <iostream>

#include "command.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/config/study.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "creepcontact/study/study.hpp"

namespace creepcontact::cli {

int study(const Command& self, const Arguments& arguments) {
  namespace po = boost::program_options;
  study::StudyOptions options;
  std::string output;
  CommandLine line(self);
  line.add_options()("jobs", po::value(&options.jobs)->value_name("N"),
                     "number of runs at a time (default: the number of cores)");
  line.add_options()("output,o", po::value(&output)->value_name("DIR"),
                     "directory of the results (default: results/<name of the study> next to the study file)");
  add_trust(line);
  if (!line.parse(arguments, "STUDY.toml")) return 0;
  constexpr int max_jobs = 1000;
  if (line.has("jobs")) line.require_within("jobs", options.jobs, max_jobs);
  options.output = output;
  options.trust_geometry = line.has(trust_option);
  std::error_code error;
  options.program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) throw SolverError("cannot find the program's own file: /proc/self/exe: " + error.message());

  const study::StudyResult result = study::run_study(config::read_study(line.positional()), run::vocabulary(), options);
  (result.exit_status == 0 ? std::cout : std::cerr << "error: ") << result.message << '\n';
  return result.exit_status;
}

}  // namespace creepcontact::cli
