#pragma once
/// Tells whether a path is the output directory of a run.

#include <filesystem>

namespace creepcontact::report {

/// @param command  that needs it, for the message
/// @throws ConfigError saying what it is instead, and what to name
void require_run(const std::filesystem::path& directory, const char* command);

}  // namespace creepcontact::report
