#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "command.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "creepcontact/cli/processes.hpp"

namespace creepcontact::cli {

namespace po = boost::program_options;

CommandLine::CommandLine(const Command& command) : command_(command), options_("Options") {
  options_.add_options()("help,h", "show this help");
}

std::vector<std::string> CommandLine::option_names() const {
  std::vector<std::string> names;
  for (const auto& option : options_.options()) names.push_back("--" + option->long_name());
  return names;
}

bool CommandLine::parse(const Arguments& arguments, const std::string& positional, const std::string& optional) {
  if (!parse(arguments, positional, optional, optional.empty() ? 1 : 2)) return false;
  if (positionals_.size() > 1) optional_ = positionals_[1];
  return true;
}

bool CommandLine::parse_several(const Arguments& arguments, const std::string& positional) {
  return parse(arguments, positional, {}, -1);
}

bool CommandLine::parse(const Arguments& arguments, const std::string& positional, const std::string& optional,
                        int most) {
  po::options_description all(options_);
  all.add_options()("positional", po::value(&positionals_));
  po::positional_options_description positions;
  positions.add("positional", most);
  const std::string help = fmt::format("; see {} {} --help", Processes::program(), command_.name);
  try {
    // an abbreviated option is an error: it would hide mistypes and change its meaning with every new option
    const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(arguments).options(all).positional(positions).style(style).run(), values_);
    po::notify(values_);
  } catch (const po::unknown_option& error) {
    const std::string name = error.get_option_name();
    const std::vector<std::string> known = option_names();
    const bool restart = name == "--restart" && std::ranges::count(known, "--resume") > 0;
    const std::string question =
        restart ? "; '--resume' continues from the last checkpoint" : did_you_mean(name, known);
    throw ConfigError(fmt::format("unknown option '{}'{}{}", name, question, help));
  } catch (const po::too_many_positional_options_error&) {
    const std::string further = optional.empty() ? "" : fmt::format(", optionally followed by {}", optional);
    throw ConfigError(fmt::format("{} takes {}, {}{}{}", command_.name,
                                  optional.empty() ? "one argument" : "one or two arguments", positional, further,
                                  help));
  } catch (const po::error& error) {
    throw ConfigError(error.what() + help);
  }
  if (has("help")) {
    std::cout << Processes::program() << ' ' << command_.name << ' ' << command_.usage << "\n\n"
              << command_.summary << "\n"
              << command_.details << '\n'
              << options_;
    return false;
  }
  if (positionals_.empty() || positionals_.front().empty())
    throw ConfigError(fmt::format("{} needs {}{}", command_.name, positional, help));
  return true;
}

void CommandLine::require_within(const std::string& option, int number, int most) const {
  if (number < 1 || number > most) throw ConfigError(fmt::format("--{}: {}; allowed: 1 to {}", option, number, most));
}

void add_overrides(CommandLine& line) {
  line.add_options()("set", po::value<std::vector<std::string>>()->value_name("key.path=value"),
                     "override a value of the configuration; may be repeated");
}

std::vector<std::string> overrides(const CommandLine& line) {
  return line.has("set") ? line.get<std::vector<std::string>>("set") : std::vector<std::string>();
}

void add_trust(CommandLine& line) {
  line.add_options()(trust_option, "let the .geo file run programs and write files");
}

}  // namespace creepcontact::cli
