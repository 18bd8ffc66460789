#include <filesystem>
#include <iostream>

#include "command.hpp"
#include "creepcontact/base/cores.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/cli/processes.hpp"
#include "creepcontact/config/reader.hpp"
#include "creepcontact/run/check.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "creepcontact/settings/mesh_formats.hpp"
#include "model_page.hpp"
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
  std::string page;
  line.add_options()("page", po::value(&page)->value_name("FILE.html"),
                     "write a page that shows the model: bodies, faces, supports, loads, contacts; also of a mesh or a "
                     "CAD file alone");
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
  const std::filesystem::path file = line.positional();
  const bool is_mesh = settings::is_mesh_file(file.extension().string());
  if (is_mesh && page.empty())
    throw ConfigError(file.string() +
                      ": not a configuration; --page FILE.html shows a mesh or a CAD model alone, and "
                      "`creepcontact faces` lists its faces");
  config::Config config = is_mesh ? mesh_alone(file, "") : config::read(file, run::vocabulary(), overrides(line));
  config.mesh.trust_geometry = line.has(trust_option);
  if (!page.empty()) {
    write_model_page(config, page);
    std::cout << "page: " << page << '\n';
  }
  if (is_mesh) return 0;
  const ThreadChoice choice(threads);
  run::check(config, std::cout, options);
  return 0;
}

}  // namespace creepcontact::cli
