#pragma once
/// Standard output that is never lost unnoticed, and never ends the program.

#include <array>
#include <streambuf>

namespace creepcontact::cli {

/// Takes the place of the buffer of std::cout for its life, and writes to the file descriptor itself. Once a write has
/// failed, what follows is dropped.
class StandardOutput : public std::streambuf {
 public:
  /// Ignores SIGPIPE, and gives those of the descriptors 0 to 2 that are closed to /dev/null: a result file would get
  /// their numbers, and the texts.
  StandardOutput();
  ~StandardOutput() override;
  StandardOutput(const StandardOutput&) = delete;
  StandardOutput& operator=(const StandardOutput&) = delete;

  /// Writes what is left. @returns errno of the first failure; 0: none, or nobody reads any more (a closed pipe)
  int finish();

 protected:
  int_type overflow(int_type letter) override;
  int sync() override;

 private:
  void write();

  std::array<char, 4096> buffer_;
  std::streambuf* before_;
  int error_ = 0;
};

}  // namespace creepcontact::cli
