#pragma once
/// One program at a time in an output directory.

#include <filesystem>

namespace creepcontact::platform {

/// Held for the object's life; the system takes it back from a process that dies. File systems without locks have none.
class DirectoryLock {
 public:
  /// Takes the lock of a directory that exists. @throws ConfigError if another process holds it
  explicit DirectoryLock(const std::filesystem::path& directory);
  ~DirectoryLock();
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;

 private:
  int file_;
};

}  // namespace creepcontact::platform
