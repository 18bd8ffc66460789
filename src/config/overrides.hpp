#pragma once
/// "key.path=value" from the command line, put into the document before it is checked.

#include <toml++/toml.h>

#include <string>

#include "diagnostics.hpp"

namespace creepcontact::config {

/// Unknown keys are left to the check of the document; what cannot be placed is reported.
void apply_override(const std::string& override_text, toml::table& document, Diagnostics& errors);

}  // namespace creepcontact::config
