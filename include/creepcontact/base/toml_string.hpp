#pragma once
/// Texts in files of TOML.

#include <string>

namespace creepcontact {

/// A string in quotation marks, on one line.
std::string toml_string(const std::string& text);

}  // namespace creepcontact
