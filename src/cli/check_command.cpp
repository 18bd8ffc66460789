#include <iostream>

#include "command.hpp"
#include "creepcontact/base/cores.hpp"
#include "creepcontact/cli/processes.hpp"
#include "creepcontact/config/reader.hpp"
#include "creepcontact/run/check.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "thread_settings.hpp"

namespace creepcontact::cli {

int check(const Command& self, const Arguments& arguments) {
  namespace po = boost::program_options;
  run::CheckOptions options;
  int threads = 0;
  CommandLine line(self);
  add_overrides(line);
  line.add_options()("start", po::bool_switch(&options.start),
                     "solve t = 0: contact forces, peak pressures, stresses, and how fast the bodies relax");
  line.add_options()("fields", po::bool_switch(&options.fields),
                     "write bodies, groups, supports, loads and gaps for ParaView, and a picture of them");
  line.add_options()("output,o", po::value(&options.output)->value_name("DIR"),
                     "directory of the results, instead of output.directory in the configuration");
  line.add_options()("threads,j", po::value(&threads)->value_name("N"),
                     "number of threads (default: the number of cores)");
  line.add_options()("resume", po::bool_switch(&options.resume),
                     "check also that a run can continue from the checkpoint in the output directory");
  add_trust(line);
  if (!line.parse(arguments, "CONFIG.toml")) return 0;
  if (line.has("threads")) line.require_within("threads", threads, cores());
  options.processes = Processes::of_one();
  config::Config config = config::read(line.positional(), run::vocabulary(), overrides(line));
  config.mesh.trust_geometry = line.has(trust_option);
  const ThreadChoice choice(threads);
  run::check(config, std::cout, options);
  return 0;
}

}  // namespace creepcontact::cli
