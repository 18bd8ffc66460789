#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "command.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "template_files.hpp"

namespace creepcontact::cli {
namespace {

std::vector<std::string> template_names() {
  std::vector<std::string> names;
  for (const TemplateFile& file : template_files())
    if (names.empty() || names.back() != file.of) names.push_back(file.of);
  return names;
}

/// The first line of the configuration, a comment.
std::string description(const std::string& name) {
  for (const TemplateFile& file : template_files())
    if (file.of == name && file.name == name + ".toml")
      return std::string(file.text.substr(2, file.text.find('\n') - 2));
  return "";
}

}  // namespace

std::string list_templates(bool markdown) {
  std::string text = markdown ? "| template | what it is |\n|---|---|\n" : "";
  for (const std::string& name : template_names())
    text += markdown ? fmt::format("| `{}` | {} |\n", name, description(name))
                     : fmt::format("{:<16}{}\n", name, description(name));
  return text;
}

int new_model(const Command& self, const Arguments& arguments) {
  namespace po = boost::program_options;
  std::string wanted;
  CommandLine line(self);
  line.add_options()("template,t", po::value(&wanted)->value_name("NAME"),
                     "what to begin with; creepcontact list templates shows them");
  if (!line.parse(arguments, "DIR, the directory of the new files")) return 0;
  const std::vector<std::string> names = template_names();
  if (std::ranges::count(names, wanted) == 0)
    throw ConfigError(wanted.empty() ? fmt::format("new: which template? Give --template NAME (there are: {})",
                                                   fmt::join(names, ", "))
                                     : fmt::format("--template: no template '{}'{} (there are: {})", wanted,
                                                   did_you_mean(wanted, names), fmt::join(names, ", ")));
  const std::filesystem::path directory = line.positional();
  if (const std::string reason = why_unwritable(directory); !reason.empty())
    throw ConfigError(
        fmt::format("{}: no files can be written there: {}; choose another directory", directory.string(), reason));
  for (const TemplateFile& file : template_files())
    if (file.of == wanted && path_exists(directory / file.name))
      throw ConfigError(
          fmt::format("{} exists already; remove it, or choose another directory", (directory / file.name).string()));
  std::filesystem::create_directories(directory);
  for (const TemplateFile& file : template_files()) {
    if (file.of != wanted) continue;
    platform::replace_file(directory / file.name, file.text);
    std::cout << (directory / file.name).string() << '\n';
  }
  const std::string configuration = (directory / (wanted + ".toml")).string();
  std::cout << fmt::format("next: creepcontact check {0}, then creepcontact run {0}\n", configuration);
  return 0;
}

}  // namespace creepcontact::cli
