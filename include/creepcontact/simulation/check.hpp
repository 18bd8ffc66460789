#pragma once
/// What `creepcontact check` prints.

#include <string>

#include "creepcontact/config/config.hpp"

namespace creepcontact::simulation {

/// Bodies, unknowns, contact pairs, rigid-body modes, estimated memory. Nothing is factored or solved.
/// @throws ModelError with every mistake; a body free to move is one
std::string check(const config::Config& config);

}  // namespace creepcontact::simulation
