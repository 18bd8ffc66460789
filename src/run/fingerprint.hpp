#pragma once
/// What the state of a run depends on beside the time: a checkpoint of another model is refused, and told why.

#include <string>
#include <vector>

#include "creepcontact/model/model.hpp"

namespace creepcontact::run {

/// Bodies with their meshes (a checksum), materials, supports, loads, temperature, contacts and the contact method, a
/// line each. Not what a user may want to change between two parts of a run: times, tolerances, integrator, outputs.
std::string fingerprint(const config::Config& config, const model::Model& model);

/// "loads changed: pressure on 'bore' was '100' and is '120'"; empty if they are the same.
std::vector<std::string> differences(const std::string& before, const std::string& now);

}  // namespace creepcontact::run
