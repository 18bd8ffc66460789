#pragma once
/// Questions about paths. The standard library's own throw texts that name neither cause nor cure.

#include <cstddef>
#include <cstdint>
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

struct FileBytes {
  std::string bytes;
  std::string failure;  ///< why they could not be read, or are too many; empty if all went well
};
/// A whole file, or all that comes from a pipe. A pipe that does not end fails beyond most_from_pipes.
FileBytes read_file(const std::filesystem::path& path, std::size_t most_bytes = SIZE_MAX);
inline constexpr std::size_t most_from_pipes = std::size_t{1} << 30;

}  // namespace creepcontact
