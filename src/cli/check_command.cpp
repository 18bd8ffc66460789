#include <iostream>

#include "command.hpp"
#include "creepcontact/config/reader.hpp"
#include "creepcontact/run/check.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "thread_settings.hpp"

namespace creepcontact::cli {

int check(const Command& self, const Arguments& arguments) {
  CommandLine line(self);
  add_overrides(line);
  add_trust(line);
  if (!line.parse(arguments, "CONFIG.toml")) return 0;
  config::Config config = config::read(line.positional(), run::vocabulary(), overrides(line));
  config.mesh.trust_geometry = line.has(trust_option);
  use_threads(0);
  run::check(config, std::cout);
  return 0;
}

}  // namespace creepcontact::cli
