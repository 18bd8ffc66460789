#pragma once
/// A directory that no other user can write to, for programs to be started in.

#include <filesystem>

namespace creepcontact::platform {

/// A new empty directory of the user's own, among the temporary files. Removed with all that is in it at the end.
class PrivateDirectory {
 public:
  /// @throws Error (exit status 4) with the place and the reason if it cannot be made
  PrivateDirectory();
  ~PrivateDirectory();
  PrivateDirectory(const PrivateDirectory&) = delete;
  PrivateDirectory& operator=(const PrivateDirectory&) = delete;

  /// Absolute.
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace creepcontact::platform
