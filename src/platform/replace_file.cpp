#include "creepcontact/platform/replace_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "creepcontact/base/error.hpp"
#include "creepcontact/platform/interrupt.hpp"

namespace creepcontact::platform {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* reason) {
  throw Error(fmt::format("cannot write '{}': {}", path.string(), reason), 4);
}

bool sync(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool synced = ::fsync(file) == 0;
  ::close(file);
  return synced;
}

}  // namespace

std::filesystem::path aside(const std::filesystem::path& path) {
  std::filesystem::path result = path;
  result += ".part";
  return result;
}

void move_into_place(const std::filesystem::path& path) {
  if (!sync(aside(path))) fail(path, std::strerror(errno));
  std::error_code error;
  std::filesystem::rename(aside(path), path, error);
  if (error) fail(path, error.message().c_str());
  // The new name is in the directory, which is a file of its own; where it cannot be synced, it is late, not wrong.
  sync(path.has_parent_path() ? path.parent_path() : ".");
}

void replace_file(const std::filesystem::path& path, std::string_view content) {
  const DelayedSignals delayed;  // nothing is left aside
  errno = 0;
  std::ofstream stream(aside(path), std::ios::binary | std::ios::trunc);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream) fail(path, errno != 0 ? std::strerror(errno) : "write error");
  move_into_place(path);
}

}  // namespace creepcontact::platform
