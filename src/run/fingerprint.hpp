#pragma once
/// What the state of a run depends on apart from the time: a checkpoint of another model is refused, with the reason.

#include <string>
#include <vector>

#include "creepcontact/model/model.hpp"

namespace creepcontact::run {

/// One line per body's mesh (a checksum) and per key that identifies the model (config::KeyInfo::identifies_model),
/// those of unused materials apart. A user may change the other keys between two parts of a run: times, tolerances,
/// integrator, outputs.
std::string fingerprint(const config::Config& config, const model::Model& model);

/// "loads[0].pressure was 100 and is now 120"; empty if they are the same.
std::vector<std::string> differences(const std::string& before, const std::string& now);

}  // namespace creepcontact::run
