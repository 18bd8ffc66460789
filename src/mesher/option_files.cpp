/// Gmsh executes NAME.opt wherever it reads NAME, without being asked to. It looks for the file by stat(), which is
/// therefore this one: it finds no .opt. Files that a .geo names itself are opened without.

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <string_view>

extern "C" int stat(const char* path, struct stat* status) noexcept {
  if (std::string_view(path).ends_with(".opt")) {
    errno = ENOENT;
    return -1;
  }
  return fstatat(AT_FDCWD, path, status, 0);
}
