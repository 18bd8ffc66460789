#pragma once
/// A text that two models share only if a state of one continues in the other.

#include <string>

#include "creepcontact/simulation/model.hpp"

namespace creepcontact::simulation {

/// Bodies with their sizes, elastic constants and creep laws; not the times, tolerances and loads, which a user may
/// want to change between two parts of a run.
std::string fingerprint(const Model& model);

}  // namespace creepcontact::simulation
