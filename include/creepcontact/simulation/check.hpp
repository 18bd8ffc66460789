#pragma once
/// What `creepcontact check` prints.

#include <iosfwd>

#include "creepcontact/config/config.hpp"

namespace creepcontact::simulation {

/// Bodies, unknowns, contact pairs, rigid-body modes, estimated memory. Nothing is factored or solved.
/// @throws ModelError with every mistake; a body free to move is one, found when the report is written
void check(const config::Config& config, std::ostream& report);

}  // namespace creepcontact::simulation
