#pragma once
/// The command `creepcontact check`, and warnings about settings.

#include <iosfwd>
#include <string>
#include <vector>

#include "creepcontact/config/config.hpp"

namespace creepcontact::run {

/// Prints bodies, unknowns, contact pairs, rigid-body modes and estimated memory. Nothing is factored or solved.
/// @throws ModelError with all errors found; a body that can move freely is found when the report is written
void check(const config::Config& config, std::ostream& report);

/// Warnings about settings that are allowed but unsuitable in combination; also issued by run().
std::vector<std::string> settings_warnings(const config::Config& config);

}  // namespace creepcontact::run
