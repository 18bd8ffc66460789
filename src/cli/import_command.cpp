#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <utility>

#include "command.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/deck/import.hpp"
#include "creepcontact/platform/memory.hpp"
#include "creepcontact/platform/replace_file.hpp"

namespace creepcontact::cli {

int import(const Command& self, const Arguments& arguments) {
  namespace po = boost::program_options;
  std::string output;
  CommandLine line(self);
  line.add_options()("output,o", po::value(&output)->value_name("DIR"),
                     "directory of the configuration and the mesh (default: the working directory)");
  if (!line.parse(arguments, "DECK.inp")) return 0;
  const std::filesystem::path path = line.positional(), directory = output.empty() ? "." : output;
  platform::return_large_blocks();
  deck::Deck deck = deck::read_deck(path);
  const std::string name = path.stem().string();
  const deck::Import made = deck::import_deck(std::move(deck), name);
  if (const std::string reason = why_unwritable(directory); !reason.empty())
    throw ConfigError(
        fmt::format("output directory {}: no files can be written there: {}; choose another directory "
                    "with --output",
                    directory.string(), reason));
  std::filesystem::create_directories(directory);
  std::vector<std::pair<std::filesystem::path, const std::string*>> files{{directory / (name + ".msh"), &made.msh}};
  if (!made.temperatures.empty()) files.emplace_back(directory / (name + "_temperature.csv"), &made.temperatures);
  files.emplace_back(directory / (name + ".toml"), &made.toml);
  for (const auto& [file, content] : files)
    if (path_exists(file))
      throw ConfigError(
          fmt::format("{} exists already; remove it, or choose another directory with --output", file.string()));
  try {
    for (const auto& [file, content] : files) platform::replace_file(file, *content);
  } catch (const Error&) {  // on a full disk: what there is of it would hinder the next import
    std::error_code ignored;
    for (const auto& [file, content] : files) std::filesystem::remove(file, ignored);
    throw;
  }
  for (const std::string& left_out : made.left_out) std::cout << "left out: " << left_out << '\n';
  std::ranges::reverse(files);  // the configuration first
  for (const auto& [file, content] : files) std::cout << file.string() << '\n';
  return 0;
}

}  // namespace creepcontact::cli
