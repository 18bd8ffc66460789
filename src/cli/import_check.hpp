#pragma once
/// What `import` has written, read back as `check` and `run` read it.

#include <filesystem>
#include <string>

namespace creepcontact::cli {

/// Reads the configuration and its mesh and makes the checks of the command `check`, without its report.
/// @param deck  for messages
/// @throws ConfigError with what a run would refuse, and the cards from which it comes
void check_import(const std::filesystem::path& configuration, const std::filesystem::path& deck);

/// Behind each line of a message the card that the comment of its table names: of "supports[2]" or "file.toml:31".
/// @param toml  text of the configuration @param file  name by which the message calls it
std::string with_cards(const std::string& message, const std::string& toml, const std::string& file);

}  // namespace creepcontact::cli
