#pragma once
/// Lock of an output directory: only one program at a time may write to it.

#include <filesystem>

namespace creepcontact::platform {

/// Held as long as the object lives; the system releases it if the process dies. No effect on file systems without
/// locks.
class DirectoryLock {
 public:
  /// Locks an existing directory. @throws ConfigError if another process holds the lock
  explicit DirectoryLock(const std::filesystem::path& directory);
  ~DirectoryLock();
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;

 private:
  int file_;
};

}  // namespace creepcontact::platform
