#include <fmt/format.h>

#include <iostream>
#include <sstream>

#include "command.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "creepcontact/plot/run_plots.hpp"

namespace creepcontact::cli {
namespace {

std::optional<bool> log_time(const std::string& word) {
  if (word == "auto") return std::nullopt;
  if (word == "yes" || word == "no") return word == "yes";
  throw ConfigError(fmt::format("--log-time: unknown choice '{}'{} (allowed: auto, yes, no)", word,
                                did_you_mean(word, {"auto", "yes", "no"})));
}

std::vector<std::string> names(const std::string& list) {
  std::vector<std::string> result;
  std::istringstream stream(list);
  for (std::string name; std::getline(stream, name, ',');)
    if (!name.empty()) result.push_back(name);
  if (result.empty()) throw ConfigError("--probes: expected names of probes, separated by commas");
  return result;
}

}  // namespace

int plot(const Command& self, const Arguments& arguments) {
  namespace po = boost::program_options;
  std::string log = "auto", probes;
  plot::PlotOptions options;
  std::string directory;
  CommandLine line(self);
  line.add_options()("log-time", po::value(&log)->value_name("auto|yes|no"),
                     "logarithmic time axis; auto (default): if the output times span more than three decades");
  line.add_options()("probes", po::value(&probes)->value_name("a,b,..."), "plot only these probes, in this order");
  line.add_options()("output,o", po::value(&directory)->value_name("DIR"),
                     "directory of the pictures (default: plots in the directory of the run)");
  if (!line.parse(arguments, "DIR, the output directory of a run")) return 0;
  options.log_time = log_time(log);
  if (line.has("probes")) options.probes = names(probes);
  options.directory = directory;
  for (std::filesystem::path picture : plot::plot_run(line.positional(), options)) {
    std::cout << picture.string() << '\n';
    std::cout << picture.replace_extension(".png").string() << '\n';
  }
  return 0;
}

}  // namespace creepcontact::cli
