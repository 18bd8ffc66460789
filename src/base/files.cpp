#include "creepcontact/base/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
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

}  // namespace creepcontact
