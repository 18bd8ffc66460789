#include "creepcontact/base/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "creepcontact/base/error.hpp"

namespace creepcontact {
namespace {

namespace fs = std::filesystem;

fs::file_type type_of(const fs::path& path) {
  std::error_code error;
  const fs::file_type type = fs::status(path, error).type();
  if (type == fs::file_type::none) throw ConfigError(fmt::format("'{}': {}", path.string(), error.message()));
  return type;
}

}  // namespace

bool path_exists(const fs::path& path) {
  return type_of(path) != fs::file_type::not_found;
}

bool path_is_directory(const fs::path& path) {
  return type_of(path) == fs::file_type::directory;
}

std::string why_unreadable(const fs::path& path) {
  std::error_code error;
  switch (fs::status(path, error).type()) {
    case fs::file_type::regular:
    case fs::file_type::fifo:
      return ::access(path.c_str(), R_OK) == 0 ? "" : std::strerror(errno);
    case fs::file_type::directory:
      return "is a directory; expected a file";
    case fs::file_type::none:
    case fs::file_type::not_found:
      return error.message();
    default:
      return "is a device or a socket; expected a file";
  }
}

std::string why_unwritable(const fs::path& directory) {
  fs::path existing = fs::absolute(directory).lexically_normal();
  // A file where a parent directory should be reads as "not found" here.
  while (!path_exists(existing) && existing.has_relative_path()) existing = existing.parent_path();
  if (!path_is_directory(existing)) return fmt::format("'{}' is not a directory", existing.string());
  if (::access(existing.c_str(), W_OK | X_OK) == 0) return "";
  return fmt::format("'{}': {}", existing.string(), std::strerror(errno));
}

FileBytes read_file(const fs::path& path, std::size_t max_bytes) {
  FileBytes result{{}, why_unreadable(path)};
  if (!result.failure.empty()) return result;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return {{}, std::strerror(errno)};
  std::error_code ignored;
  const bool is_pipe = fs::status(path, ignored).type() == fs::file_type::fifo;
  const std::size_t most = is_pipe ? std::min(max_bytes, max_from_pipes) : max_bytes;
  std::string part(std::size_t{1} << 16, '\0');
  while (stream.read(part.data(), static_cast<std::streamsize>(part.size())), stream.gcount() > 0) {
    result.bytes.append(part, 0, static_cast<std::size_t>(stream.gcount()));
    if (result.bytes.size() > most)
      return {{}, fmt::format("longer than {:.4g} MB", static_cast<double>(most) / (1 << 20))};
  }
  if (stream.bad()) return {{}, std::strerror(errno)};
  return result;
}

}  // namespace creepcontact
