#pragma once
/// Work that goes on while the thread that gives it does something else.

#include <functional>
#include <future>

namespace creepcontact::platform {

/// One piece of work at a time, in a thread of its own. To be used by one thread.
class Background {
 public:
  /// Waits for the work under way; what it throws is lost.
  ~Background() = default;
  Background() = default;
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Waits for the piece before, then starts this one. Where the system has no thread to give, it is done at once.
  /// @throws what the piece before has thrown; this one is then not started
  void start(std::function<void()> work);
  /// True while the last piece is under way. Does not wait.
  bool busy() const;
  /// Waits for the last piece. @throws what it has thrown, once
  void wait();

 private:
  std::future<void> last_;  // of std::async: its destructor waits
};

}  // namespace creepcontact::platform
