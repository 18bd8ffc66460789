#pragma once
/// Queries about paths. Unlike those of the standard library, their errors name the cause and the remedy.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace creepcontact {

/// @throws ConfigError with path and reason if it cannot be determined: circular links, a name that is too long, a
/// directory without permission to search
bool path_exists(const std::filesystem::path& path);
/// As path_exists().
bool path_is_directory(const std::filesystem::path& path);

/// Why a path cannot be read: "No such file or directory", "is a directory", "is a device". Empty for a readable file
/// or pipe.
std::string why_unreadable(const std::filesystem::path& path);

/// Why no files can be made in a directory that exists or may be made: "Permission denied", "'a' is not a directory".
/// Empty if they can, as far as permissions tell. Makes nothing. @throws as path_exists()
std::string why_unwritable(const std::filesystem::path& directory);

/// Content of a file, or why it could not be read.
struct FileBytes {
  std::string bytes;
  std::string failure;  ///< why the bytes could not be read, or are too many; empty on success
};
/// Reads a whole file, or a pipe to its end. A pipe with more than max_from_pipes bytes is a failure.
FileBytes read_file(const std::filesystem::path& path, std::size_t max_bytes = SIZE_MAX);
inline constexpr std::size_t max_from_pipes = std::size_t{1} << 30;

}  // namespace creepcontact
