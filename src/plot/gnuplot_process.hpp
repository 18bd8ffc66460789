#pragma once
/// gnuplot as a process.

#include <filesystem>
#include <string>
#include <vector>

namespace creepcontact::plot {

/// Runs gnuplot in `directory`, without a shell and without the user's own settings, and waits for it.
/// @throws ConfigError if it is not installed; Error (exit status 4) with its message if it fails
void run_gnuplot(const std::filesystem::path& directory, const std::vector<std::string>& arguments);

}  // namespace creepcontact::plot
