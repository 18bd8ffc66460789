#include "creepcontact/platform/private_directory.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "creepcontact/base/error.hpp"

namespace creepcontact::platform {

PrivateDirectory::PrivateDirectory() {
  std::error_code failure;
  const std::filesystem::path place = std::filesystem::absolute(std::filesystem::temp_directory_path(failure), failure);
  std::string pattern = (place / "creepcontact_XXXXXX").string();
  if (failure || ::mkdtemp(pattern.data()) == nullptr)
    throw Error(fmt::format("cannot make a directory for temporary files in '{}': {}; set TMPDIR to a directory that "
                            "can be written to",
                            place.string(), failure ? failure.message() : std::strerror(errno)),
                4);
  path_ = pattern;
}

PrivateDirectory::~PrivateDirectory() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace creepcontact::platform
