#pragma once
/// Atomic replacement of files: a file is complete, old or new, whatever interrupts the program.

#include <cstdio>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace creepcontact::platform {

/// Results are written into directories that may come from others, with symbolic links among their files. No function
/// here writes through one: what a link leads to stays as it is.

/// Why a file cannot be written, by errno, in words of the system's; of a limit (EFBIG) also which.
std::string write_failure(int error);

/// Path in the same directory at which the new version of `path` is prepared.
std::filesystem::path aside(const std::filesystem::path& path);

/// Makes a new empty file for writing, whatever had its name before; a link or a file that a full disk has left is
/// removed, not followed. A device is opened instead. @returns its descriptor, which the caller closes
/// @throws Error (exit status 4) with the name and the reason
int create_file(const std::filesystem::path& path);

/// create_file() as a stream. @returns null with errno where that throws
std::FILE* create_stream(const std::filesystem::path& path);

/// Opens an existing file at its end (`append`), or for changes. @returns null with errno if there is none, or a link
std::FILE* reopen_stream(const std::filesystem::path& path, bool append);

/// Makes a directory for results inside an output directory, if it does not exist.
/// @throws ConfigError with the name and the reason; also if it is a symbolic link, through which results would be
///   written to another place
void make_inner_directory(const std::filesystem::path& directory);

/// Syncs aside(path) to disk and renames it to `path`. @throws Error with the name and the reason given by the system
void move_into_place(const std::filesystem::path& path);

/// When a new file must be on the disk itself. Until then a crash of the system or a power cut may lose it; the end of
/// the program, however sudden, does not.
enum class Durable { at_once, when_synced };

/// Writes `content` to a new file aside(path) and moves it into place; where it cannot be written, nothing of it is
/// left. Cost with Durable::at_once: two syncs, some milliseconds.
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
