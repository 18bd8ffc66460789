#include <fmt/format.h>

#include <iostream>
#include <sstream>

#include "command.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "creepcontact/plot/overlay_plots.hpp"
#include "creepcontact/study/study.hpp"

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

/// @param directories  of runs, or a single directory of a study
std::vector<std::filesystem::path> pictures(const std::vector<std::filesystem::path>& directories,
                                            plot::PlotOptions options) {
  for (const std::filesystem::path& directory : directories)
    if (study::is_study_directory(directory)) {
      if (directories.size() == 1) return study::plot_study_histories(directory, options);
      throw ConfigError(
          fmt::format("'{0}' is the directory of a study: plot it alone, or name its runs ('{0}/runs/run_001')",
                      directory.string()));
    }
  if (directories.size() == 1) return plot::plot_run(directories.front(), options);
  if (options.directory.empty()) options.directory = "plots";
  return plot::plot_overlay(plot::labelled_by_directory(directories), "", options);
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
                     "directory of the pictures (default: plots, in the directory of the run or the study; with "
                     "several, in the working directory)");
  if (!line.parse_several(arguments, "DIR, the output directory of a run or of a study")) return 0;
  options.log_time = log_time(log);
  if (line.has("probes")) options.probes = names(probes);
  options.directory = directory;
  for (std::filesystem::path picture : pictures({line.positionals().begin(), line.positionals().end()}, options)) {
    std::cout << picture.string() << '\n';
    std::cout << picture.replace_extension(".png").string() << '\n';
  }
  return 0;
}

}  // namespace creepcontact::cli
