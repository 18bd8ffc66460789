#include "command.hpp"
#include "creepcontact/base/error.hpp"

namespace creepcontact::cli {

int study(const Command& self, const Arguments& arguments) {
  namespace po = boost::program_options;
  CommandLine line(self);
  line.add_options()("jobs", po::value<int>()->value_name("N"), "runs at a time");
  line.add_options()("output,o", po::value<std::string>()->value_name("DIR"), "where results go");
  if (!line.parse(arguments, "STUDY.toml")) return 0;
  throw ConfigError("study: not available in this version");
}

}  // namespace creepcontact::cli
