#pragma once
/// Questions about paths. The standard library's own throw texts that name neither cause nor cure.

#include <filesystem>
#include <string>

namespace creepcontact {

/// @throws ConfigError with path and reason where it cannot be told: links in a circle, a name that is too long, a
/// directory that may not be searched
bool path_exists(const std::filesystem::path& path);
/// As path_exists().
bool path_is_directory(const std::filesystem::path& path);

/// "No such file or directory", "is a directory", "is a device": empty if there is a file or a pipe that may be read.
std::string why_unreadable(const std::filesystem::path& path);

}  // namespace creepcontact
