#pragma once
/// Words of a command of the shell.

#include <string>

namespace creepcontact::study {

/// The text as one word: in single quotes if it has letters that mean something to the shell.
std::string shell_quoted(const std::string& text);

}  // namespace creepcontact::study
