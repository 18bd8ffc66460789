#include <fmt/format.h>
#include <unistd.h>

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
#include "creepcontact/run/vocabulary.hpp"
#include "import_check.hpp"

namespace creepcontact::cli {
namespace {

/// A directory for what is not checked yet, next to where it will be; it goes with the object.
class Workplace {
 public:
  explicit Workplace(const std::filesystem::path& directory) {
    for (std::filesystem::path made = directory; !made.empty() && !path_exists(made); made = made.parent_path())
      new_.push_back(made);
    std::filesystem::create_directories(directory);
    path_ = directory / fmt::format(".import_{}", getpid());
    if (!std::filesystem::create_directory(path_))
      throw ConfigError(fmt::format("{} exists already; remove it", path_.string()));
  }
  ~Workplace() {
    std::error_code unused;
    std::filesystem::remove_all(path_, unused);
    for (const std::filesystem::path& made : new_) std::filesystem::remove(made, unused);  // if nothing is in it
  }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::vector<std::filesystem::path> new_;
};

}  // namespace

int import(const Command& self, const Arguments& arguments) {
  namespace po = boost::program_options;
  std::string output;
  bool unchecked = false;
  CommandLine line(self);
  line.add_options()("output,o", po::value(&output)->value_name("DIR"),
                     "directory of the configuration and the mesh (default: the working directory)");
  line.add_options()("no-check", po::bool_switch(&unchecked),
                     "write the configuration even if a run would refuse it; needs less memory");
  if (!line.parse(arguments, "DECK.inp")) return 0;
  const std::filesystem::path path = line.positional(), directory = output.empty() ? "." : output;
  platform::return_large_blocks();
  deck::Deck deck = deck::read_deck(path);
  const std::string name = path.stem().string();
  deck::Import made = deck::import_deck(std::move(deck), name);
  if (const std::string reason = why_unwritable(directory); !reason.empty())
    throw ConfigError(
        fmt::format("output directory {}: no files can be written there: {}; choose another directory "
                    "with --output",
                    directory.string(), reason));
  std::vector<std::pair<std::string, std::string>> files{{name + ".msh", std::move(made.msh)}};
  std::ranges::move(made.tables, std::back_inserter(files));
  files.emplace_back(name + ".toml", config::to_toml(made.config, run::vocabulary(), made.comments));
  made.config = {};  // large decks: its memory, before the check
  for (const auto& [file, content] : files)
    if (path_exists(directory / file))
      throw ConfigError(fmt::format("{} exists already; remove it, or choose another directory with --output",
                                    (directory / file).string()));
  const Workplace workplace(directory);
  for (auto& [file, content] : files) {
    platform::replace_file(workplace.path() / file, content);
    std::string().swap(content);  // large decks: their memory, before the check
  }
  if (!unchecked) check_import(workplace.path() / (name + ".toml"), path);
  for (const auto& [file, content] : files) std::filesystem::rename(workplace.path() / file, directory / file);
  for (const std::string& found : made.found) std::cout << "found: " << found << '\n';
  for (const std::string& left_out : made.left_out) std::cout << "left out: " << left_out << '\n';
  if (unchecked) std::cout << "not checked: a run may refuse it\n";
  std::ranges::reverse(files);  // the configuration first
  for (const auto& [file, content] : files) std::cout << (directory / file).string() << '\n';
  return 0;
}

}  // namespace creepcontact::cli
