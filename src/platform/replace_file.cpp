#include "creepcontact/platform/replace_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/platform/interrupt.hpp"

namespace creepcontact::platform {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* reason) {
  throw Error(fmt::format("cannot write '{}': {}", path.string(), reason), 4);
}

/// @param how  a system call that takes the descriptor of the file and returns 0 @returns false with errno
template <class How>
bool with_descriptor(const std::filesystem::path& path, How how) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool done = how(file) == 0;
  const int error = errno;
  ::close(file);
  errno = error;
  return done;
}

bool sync(const std::filesystem::path& path) {
  return with_descriptor(path, ::fsync);
}

/// A new name is in the directory, which is a file of its own; where it cannot be synced, it is late, not wrong.
void sync_directory_of(const std::filesystem::path& path) {
  sync(path.has_parent_path() ? path.parent_path() : ".");
}

void rename_aside(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::rename(aside(path), path, error);
  if (error) fail(path, error.message().c_str());
}

}  // namespace

std::filesystem::path aside(const std::filesystem::path& path) {
  std::filesystem::path result = path;
  result += ".part";
  return result;
}

void move_into_place(const std::filesystem::path& path) {
  if (!sync(aside(path))) fail(path, std::strerror(errno));
  rename_aside(path);
  sync_directory_of(path);
}

void replace_file(const std::filesystem::path& path, std::string_view content, Durable durable) {
  const DelayedSignals delayed;  // nothing is left aside
  errno = 0;
  std::ofstream stream(aside(path), std::ios::binary | std::ios::trunc);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream) fail(path, errno != 0 ? std::strerror(errno) : "write error");
  if (durable == Durable::at_once)
    move_into_place(path);
  else
    rename_aside(path);
}

bool rewrite_end(const std::filesystem::path& path, std::size_t begin, std::string_view end) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return false;
  const ssize_t written = ::pwrite(file, end.data(), end.size(), static_cast<off_t>(begin));
  return ::close(file) == 0 && written == static_cast<ssize_t>(end.size());
}

void sync_files(std::span<const std::filesystem::path> paths) {
  // All are on their way before the first is waited for: then the others take no time of their own.
  for (const std::filesystem::path& path : paths)
    with_descriptor(path, [](int file) { return ::sync_file_range(file, 0, 0, SYNC_FILE_RANGE_WRITE); });
  std::set<std::filesystem::path> directories;
  for (const std::filesystem::path& path : paths) {
    if (!sync(path) && errno != ENOENT) fail(path, std::strerror(errno));
    if (directories.insert(path.parent_path()).second) sync_directory_of(path);
  }
}

}  // namespace creepcontact::platform
