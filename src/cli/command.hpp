#pragma once
/// The commands of the program, and what they share in reading their arguments.

#include <boost/program_options.hpp>
#include <optional>
#include <string>
#include <vector>

namespace creepcontact::cli {

using Arguments = std::vector<std::string>;

struct Command {
  std::string name;
  std::string usage;    ///< what follows the name: "CONFIG.toml [options]"
  std::string summary;  ///< one line
  /// @returns the exit status; throws Error
  int (*execute)(const Command& self, const Arguments& arguments);
  std::string details = {};  ///< further lines of the command's own help
};

int run(const Command& self, const Arguments& arguments);
int heat_alone(const Command& self, const Arguments& arguments);
int check(const Command& self, const Arguments& arguments);
int study(const Command& self, const Arguments& arguments);
int plot(const Command& self, const Arguments& arguments);
int report(const Command& self, const Arguments& arguments);
int picture(const Command& self, const Arguments& arguments);
int faces(const Command& self, const Arguments& arguments);
int new_model(const Command& self, const Arguments& arguments);
int import(const Command& self, const Arguments& arguments);
int fit(const Command& self, const Arguments& arguments);
int material(const Command& self, const Arguments& arguments);
int list(const Command& self, const Arguments& arguments);

/// Arguments of one command: options, one positional argument that must be given, and one that may be.
class CommandLine {
 public:
  explicit CommandLine(const Command& command);

  boost::program_options::options_description_easy_init add_options() { return options_.add_options(); }

  /// @param positional  name of the positional argument, for messages.
  /// @param optional    name of a second one that need not be given; empty: there is none.
  /// @returns false if help was asked for and has been printed
  /// @throws ConfigError for an unknown option (naming the nearest), a wrong or missing value
  bool parse(const Arguments& arguments, const std::string& positional, const std::string& optional = {});

  /// Parses the arguments as parse() does, with one or more positional arguments.
  bool parse_several(const Arguments& arguments, const std::string& positional);

  const std::vector<std::string>& positionals() const { return positionals_; }
  const std::string& positional() const { return positionals_.front(); }
  const std::optional<std::string>& optional() const { return optional_; }
  bool has(const std::string& option) const { return values_.count(option) > 0; }
  /// @throws ConfigError if the number given with an option is none from 1 to `most`
  void require_within(const std::string& option, int number, int most) const;
  template <class T>
  const T& get(const std::string& option) const {
    return values_[option].as<T>();
  }

 private:
  std::vector<std::string> option_names() const;
  /// @param most  positional arguments; -1: any number
  bool parse(const Arguments& arguments, const std::string& positional, const std::string& optional, int most);

  const Command& command_;
  boost::program_options::options_description options_;
  boost::program_options::variables_map values_;
  std::vector<std::string> positionals_;
  std::optional<std::string> optional_;
};

/// Adds --set key.path=value.
void add_overrides(CommandLine& line);
std::vector<std::string> overrides(const CommandLine& line);

inline constexpr const char* trust_option = "trust-geometry";
/// Adds it.
void add_trust(CommandLine& line);

}  // namespace creepcontact::cli
