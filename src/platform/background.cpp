#include "creepcontact/platform/background.hpp"

#include <chrono>
#include <system_error>

#include "creepcontact/base/log.hpp"

namespace creepcontact::platform {

void Background::start(std::function<void()> work) {
  wait();
  try {
    last_ = std::async(std::launch::async, [work, sink = log::sink()] {
      const log::Redirection redirection(sink);
      work();
    });
  } catch (const std::system_error&) {  // a limit of threads or of memory
    work();
  }
}

bool Background::busy() const {
  return last_.valid() && last_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
}

void Background::wait() {
  if (last_.valid()) last_.get();
}

}  // namespace creepcontact::platform
