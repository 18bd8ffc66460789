#pragma once
/// What `creepcontact check` prints, and what is wrong without being an error.

#include <iosfwd>
#include <string>
#include <vector>

#include "creepcontact/config/config.hpp"

namespace creepcontact::run {

/// Bodies, unknowns, contact pairs, rigid-body modes, estimated memory. Nothing is factored or solved.
/// @throws ModelError with every mistake; a body free to move is one, found when the report is written
void check(const config::Config& config, std::ostream& report);

/// Settings that work, but not well together; `run` says so too.
std::vector<std::string> settings_warnings(const config::Config& config);

}  // namespace creepcontact::run
