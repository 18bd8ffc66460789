#pragma once
/// Whether a run that is to be resumed has anything left to do.

#include <filesystem>
#include <string>

#include "creepcontact/config/config.hpp"
#include "creepcontact/model/model.hpp"

namespace creepcontact::run {

/// Changes no file. @param directory  with the results of the run.
/// @returns a sentence on why nothing is left to do; empty: the run goes on from its checkpoint.
/// @throws ConfigError if the run has ended, and its checkpoint is missing or is of another model
std::string nothing_left(const config::Config& config, const model::Model& model,
                         const std::filesystem::path& directory);

}  // namespace creepcontact::run
