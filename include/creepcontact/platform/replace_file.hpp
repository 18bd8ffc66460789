#pragma once
/// Atomic replacement of files: a file is complete, old or new, whatever interrupts the program.

#include <filesystem>
#include <span>
#include <string_view>

namespace creepcontact::platform {

/// Path in the same directory at which the new version of `path` is prepared.
std::filesystem::path aside(const std::filesystem::path& path);

/// Syncs aside(path) to disk and renames it to `path`. @throws Error with the name and the reason given by the system
void move_into_place(const std::filesystem::path& path);

/// When a new file must be on the disk itself. Until then a crash of the system or a power cut may lose it; the end of
/// the program, however sudden, does not.
enum class Durable { at_once, when_synced };

/// Writes `content` to aside(path) and moves it into place. Cost with Durable::at_once: two syncs, some milliseconds.
/// @throws Error as move_into_place()
void replace_file(const std::filesystem::path& path, std::string_view content, Durable durable = Durable::at_once);

/// Writes `end` over a file from `begin` on, at once: the end of the program leaves the old or the new end. Unlike a
/// replacement it makes no file system wait for the disk. Precondition: the file does not become shorter
/// @returns false if there is no such file or it cannot be written
bool rewrite_end(const std::filesystem::path& path, std::size_t begin, std::string_view end);

/// Waits until the files and their directories are on the disk itself; files that were removed since are skipped.
/// Cost: little more than one sync for any number of files. @throws Error with the name and the reason
void sync_files(std::span<const std::filesystem::path> paths);

}  // namespace creepcontact::platform
