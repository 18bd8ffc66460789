#pragma once
/// Atomic replacement of files: a file is complete, old or new, whatever interrupts the program.

#include <filesystem>
#include <string_view>

namespace creepcontact::platform {

/// Path in the same directory at which the new version of `path` is prepared.
std::filesystem::path aside(const std::filesystem::path& path);

/// Syncs aside(path) to disk and renames it to `path`. @throws Error with the name and the reason given by the system
void move_into_place(const std::filesystem::path& path);

/// Writes `content` to aside(path) and moves it into place. @throws Error as move_into_place()
void replace_file(const std::filesystem::path& path, std::string_view content);

}  // namespace creepcontact::platform
