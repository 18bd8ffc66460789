#pragma once
/// Mistakes of the TOML syntax in words of our own.

#include <string>
#include <string_view>
#include <vector>

#include "creepcontact/config/location.hpp"
#include "creepcontact/config/schema.hpp"

namespace creepcontact::config {

/// What is wrong at a place where the parser stopped, and how to write it.
/// @param text         of the whole file
/// @param description  the parser's own words, returned where there are no better ones
std::string explain_syntax(const std::string& text, const Location& where, std::string_view description,
                           const std::vector<KeyInfo>& schema);

}  // namespace creepcontact::config
