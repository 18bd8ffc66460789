#include "creepcontact/platform/companions.hpp"

#include <unistd.h>

#include <system_error>

namespace creepcontact::platform {

namespace fs = std::filesystem;

std::vector<fs::path> companion_places(const std::string& name) {
  std::error_code failure;
  const fs::path here = fs::read_symlink("/proc/self/exe", failure).parent_path();
  return {here / name, (here / CREEPCONTACT_COMPANIONS_FROM_BIN / name).lexically_normal(),
          fs::path(CREEPCONTACT_COMPANIONS_INSTALLED) / name};
}

fs::path find_companion(const std::string& name, bool executable) {
  for (const fs::path& place : companion_places(name))
    if (::access(place.c_str(), executable ? X_OK : R_OK) == 0) return place;
  return {};
}

}  // namespace creepcontact::platform
