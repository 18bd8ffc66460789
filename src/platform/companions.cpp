#include "creepcontact/platform/companions.hpp"

#include <dlfcn.h>
#include <unistd.h>

#include <system_error>

namespace creepcontact::platform {

namespace fs = std::filesystem;

namespace {

/// The directory of the program, or of the shared library that this code is in.
fs::path program_directory() {
  static const int anchor = 0;
  Dl_info found{};
  // The linker knows a program only by how it was called.
  if (::dladdr(&anchor, &found) != 0 && found.dli_fname != nullptr)
    if (const fs::path library = found.dli_fname; library.extension() == ".so")
      return fs::absolute(library).parent_path();
  std::error_code failure;
  return fs::read_symlink("/proc/self/exe", failure).parent_path();
}

}  // namespace

std::vector<fs::path> companion_places(const std::string& name) {
  const fs::path here = program_directory();
  return {here / name, (here / CREEPCONTACT_COMPANIONS_FROM_BIN / name).lexically_normal(),
          fs::path(CREEPCONTACT_COMPANIONS_INSTALLED) / name};
}

fs::path find_companion(const std::string& name, bool executable) {
  for (const fs::path& place : companion_places(name))
    if (::access(place.c_str(), executable ? X_OK : R_OK) == 0) return place;
  return {};
}

fs::path find_shared(const std::string& name) {
  const fs::path here = program_directory();
  for (const fs::path& place : {here / name, (here / CREEPCONTACT_SHARED_FROM_BIN / name).lexically_normal(),
                                fs::path(CREEPCONTACT_SHARED_INSTALLED) / name})
    if (::access(place.c_str(), R_OK) == 0) return place;
  return {};
}

}  // namespace creepcontact::platform
