#pragma once
/// A request to end that long iterations heed.

#include <exception>
#include <functional>
#include <utility>

namespace creepcontact {

/// Thrown where a request to end is heeded. Nothing has failed, so it is neither an Error nor a RecoverableError: what
/// tries again after those lets it pass, up to whoever made the request.
struct Cancelled : std::exception {
  const char* what() const noexcept override { return "ended on request"; }
};

/// To be asked between iterations. Cost: that of the question, some loads from memory.
class StopRequest {
 public:
  /// Never asks.
  StopRequest() = default;
  /// @param is_made  whether the end is requested; it is asked from the threads that iterate
  explicit StopRequest(std::function<bool()> is_made) : is_made_(std::move(is_made)) {}
  /// @throws Cancelled if the end is requested
  void heed() const {
    if (is_made_ && is_made_()) throw Cancelled();
  }

 private:
  std::function<bool()> is_made_;
};

}  // namespace creepcontact
