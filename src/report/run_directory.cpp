#include "run_directory.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"

namespace creepcontact::report {

void require_run(const std::filesystem::path& directory, const char* command) {
  const std::string name = directory.string();
  if (!path_exists(directory))
    throw ConfigError(
        fmt::format("there is no directory '{}'; {} needs the output directory of a run, which `creepcontact run` "
                    "names at its end",
                    name, command));
  if (!path_is_directory(directory)) {
    const bool is_configuration = directory.extension() == ".toml";
    throw ConfigError(
        fmt::format("'{}' is a file; {} needs the output directory of a run{}", name, command,
                    is_configuration ? fmt::format(". Run the configuration first: creepcontact run {}", name) : ""));
  }
  if (path_exists(directory / "study.csv"))
    throw ConfigError(
        fmt::format("'{0}' is the directory of a study; name its runs: {0}/runs/run_001 and so on", name));
  const bool is_run =
      std::ranges::any_of(std::initializer_list<const char*>{"summary.json", "history.csv", "fields.pvd"},
                          [&](const char* file) { return path_exists(directory / file); });
  if (!is_run)
    throw ConfigError(fmt::format(
        "'{}' is not the output directory of a run: it has no summary.json, history.csv or fields.pvd", name));
}

}  // namespace creepcontact::report
