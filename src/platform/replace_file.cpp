#include "creepcontact/platform/replace_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/platform/interrupt.hpp"

namespace creepcontact::platform {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
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
  if (error) fail(path, error.message());
}

/// See create_file(). @returns -1 with errno if it cannot be made
int try_to_create(const std::filesystem::path& path) {
  struct stat found {};
  if (::lstat(path.c_str(), &found) == 0) {
    const bool is_device = S_ISCHR(found.st_mode) || S_ISBLK(found.st_mode);  // the user's own choice
    if (is_device) return ::open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
    if (::unlink(path.c_str()) != 0 && errno != ENOENT) return -1;
  }
  constexpr mode_t mode = 0666;  // less the umask
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
  if (file >= 0 || errno != EEXIST) return file;
  // Another process has made one of this name at the same time.
  if (::unlink(path.c_str()) != 0 && errno != ENOENT) return -1;
  return ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
}

/// @returns null with errno if the descriptor is none
std::FILE* stream_of(int file, const char* mode) {
  if (file < 0) return nullptr;
  if (std::FILE* stream = ::fdopen(file, mode)) return stream;
  const int error = errno;
  ::close(file);
  errno = error;
  return nullptr;
}

/// @returns 0 or the error
int write_new(const std::filesystem::path& path, std::string_view content) {
  const int file = try_to_create(path);
  if (file < 0) return errno;
  int error = 0;
  while (!content.empty() && error == 0) {
    const ssize_t written = ::write(file, content.data(), content.size());
    if (written < 0 && errno != EINTR) error = errno;
    if (written > 0) content.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::close(file) != 0 && error == 0) error = errno;
  return error;
}

}  // namespace

std::string write_failure(int error) {
  if (error == 0) return "write error";
  const std::string words = std::strerror(error);
  return error == EFBIG ? words + " (the limit of the shell, ulimit -f, or that of the file system)" : words;
}

std::filesystem::path aside(const std::filesystem::path& path) {
  std::filesystem::path result = path;
  result += ".part";
  return result;
}

void move_into_place(const std::filesystem::path& path) {
  if (!sync(aside(path))) fail(path, write_failure(errno));
  rename_aside(path);
  sync_directory_of(path);
}

int create_file(const std::filesystem::path& path) {
  const int file = try_to_create(path);
  if (file < 0) fail(path, write_failure(errno));
  return file;
}

std::FILE* create_stream(const std::filesystem::path& path) {
  return stream_of(try_to_create(path), "wb");
}

std::FILE* reopen_stream(const std::filesystem::path& path, bool append) {
  return stream_of(::open(path.c_str(), (append ? O_WRONLY | O_APPEND : O_RDWR) | O_NOFOLLOW | O_CLOEXEC),
                   append ? "ab" : "r+b");
}

void make_inner_directory(const std::filesystem::path& directory) {
  std::error_code failure;
  if (std::filesystem::is_symlink(directory, failure))
    throw ConfigError(
        fmt::format("'{}' is a symbolic link, and results are not written through links that lie in an output "
                    "directory; remove the link, or give the directory that it leads to as the output",
                    directory.string()));
  std::filesystem::create_directories(directory, failure);
  if (failure)
    throw ConfigError(fmt::format("cannot make the directory '{}': {}", directory.string(), failure.message()));
}

void replace_file(const std::filesystem::path& path, std::string_view content, Durable durable) {
  const DelayedSignals delayed;  // nothing is left aside
  const std::filesystem::path part = aside(path);
  if (const int error = write_new(part, content); error != 0) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);  // on a full disk it would take what is left
    fail(path, write_failure(error));
  }
  if (durable == Durable::at_once)
    move_into_place(path);
  else
    rename_aside(path);
}

bool rewrite_end(const std::filesystem::path& path, std::size_t begin, std::string_view end) {
  const int file = ::open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
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
    if (!sync(path) && errno != ENOENT) fail(path, write_failure(errno));
    if (directories.insert(path.parent_path()).second) sync_directory_of(path);
  }
}

}  // namespace creepcontact::platform
