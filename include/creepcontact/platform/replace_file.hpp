#pragma once
/// Files that are either the old or the new one as a whole, whatever interrupts the program.

#include <filesystem>
#include <string_view>

namespace creepcontact::platform {

/// The name beside `path` under which the new file is prepared.
std::filesystem::path aside(const std::filesystem::path& path);

/// Syncs aside(path) to disk and renames it to `path`. @throws Error naming the file and the system's reason
void move_into_place(const std::filesystem::path& path);

/// Writes aside(path) and moves it into place. @throws Error
void replace_file(const std::filesystem::path& path, std::string_view content);

}  // namespace creepcontact::platform
