#include "creepcontact/platform/interrupt.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <mutex>
#include <string_view>

namespace creepcontact::platform {
namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
using Actions = std::array<struct sigaction, signals.size()>;

// All that the handler reads; it may run in any thread.
std::atomic<int> owners = 0, delays = 0;                   // living Interrupts and DelayedSignals
std::atomic<int> waiting = 0;                              // the signal that waits
std::array<std::atomic<bool>, signals.size()> requests{};  // by signal
std::atomic<pid_t> process = 0;                            // that the handlers were made for
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<pid_t>::is_always_lock_free);

Actions found;  // by the first Interrupt
std::mutex owning;

void tell(std::string_view text) {
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

[[noreturn]] void end_at_once(int signal, bool again) {
  tell(signal == SIGINT    ? "error: interrupted (SIGINT)"
       : signal == SIGTERM ? "error: interrupted (SIGTERM)"
                           : "error: interrupted (SIGHUP)");
  tell(again ? " a second time: ended at once; what was not saved before is lost\n"
             : ": ended before there were results to save\n");
  ::_exit(interrupted_status);
}

std::size_t index_of(int signal) {
  return signal == SIGINT ? 0 : signal == SIGTERM ? 1 : 2;
}

extern "C" void heed(int signal) {
  const int error = errno;
  if (::getpid() !=
      process) {  // a child that has not replaced its program: the signal does there what it does anywhere
    ::signal(signal, SIG_DFL);
    ::raise(signal);
  } else if (owners > 0) {
    if (requests[index_of(signal)].exchange(true)) end_at_once(signal, true);
  } else if (delays > 0) {
    waiting = signal;
  } else {
    end_at_once(signal, false);
  }
  errno = error;
}

void install(Actions* old) {
  process = ::getpid();
  for (std::size_t i = 0; i < signals.size(); ++i) {
    struct sigaction before {
    }, action{};
    sigaction(signals[i], nullptr, &before);
    if (old) (*old)[i] = before;
    // A terminal that is closed, a connection that is lost; nohup asks to ignore that.
    if (signals[i] == SIGHUP && before.sa_handler == SIG_IGN) continue;
    action.sa_handler = heed;
    action.sa_flags = SA_RESTART;
    sigaction(signals[i], &action, nullptr);
  }
}

sigset_t signal_set() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : signals) sigaddset(&set, signal);
  return set;
}

}  // namespace

void end_at_signals() {
  install(nullptr);
  std::signal(SIGCHLD, SIG_DFL);  // ignored, as a program that starts this one may leave it, it hides how processes end
  // A file that may not grow any more (ulimit -f) is then told like a full disk, by what writes to it.
  std::signal(SIGXFSZ, SIG_IGN);
  const sigset_t set = signal_set();
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

BlockedSignals::BlockedSignals() {
  const sigset_t set = signal_set();
  pthread_sigmask(SIG_BLOCK, &set, &before_);
}
BlockedSignals::~BlockedSignals() {
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

Interrupt::Interrupt() {
  const std::scoped_lock lock(owning);
  if (owners > 0) {
    ++owners;
    return;
  }
  for (std::atomic<bool>& request : requests) request = false;
  ++owners;
  install(&found);
}

Interrupt::~Interrupt() {
  const std::scoped_lock lock(owning);
  if (owners == 1)
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &found[i], nullptr);
  --owners;
}

bool Interrupt::requested() const {
  for (const std::atomic<bool>& request : requests)
    if (request) return true;
  return false;
}

DelayedSignals::DelayedSignals() {
  ++delays;
}

DelayedSignals::~DelayedSignals() {
  if (--delays > 0 || waiting == 0) return;
  const int signal = waiting.exchange(0);
  if (owners == 0) end_at_once(signal, false);
}

}  // namespace creepcontact::platform
