#include "creepcontact/platform/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "creepcontact/base/error.hpp"
#include "creepcontact/platform/interrupt.hpp"

namespace creepcontact::platform {
namespace {

int exit_status(int wait_status) {
  return WIFSIGNALED(wait_status) ? 128 + WTERMSIG(wait_status) : WEXITSTATUS(wait_status);
}

/// Copies of descriptors out of the way of those that a child is to get.
class Copies {
 public:
  explicit Copies(const ChildSetup& setup) {
    int first_free = STDERR_FILENO + 1;
    for (const auto& [here, there] : setup.descriptors) first_free = std::max(first_free, there + 1);
    for (const auto& [here, there] : setup.descriptors)
      pairs_.emplace_back(::fcntl(here, F_DUPFD_CLOEXEC, first_free), there);
    for (int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
      const bool is_given =
          std::any_of(pairs_.begin(), pairs_.end(), [&](const auto& pair) { return pair.second == standard; });
      if (is_given) continue;
      const int null = ::open("/dev/null", O_RDWR | O_CLOEXEC);
      pairs_.emplace_back(::fcntl(null, F_DUPFD_CLOEXEC, first_free), standard);
      ::close(null);
    }
  }
  ~Copies() {
    for (const auto& [copy, there] : pairs_) ::close(copy);
  }
  Copies(const Copies&) = delete;
  Copies& operator=(const Copies&) = delete;

  bool are_made() const {
    return std::all_of(pairs_.begin(), pairs_.end(), [](const auto& pair) { return pair.first >= 0; });
  }
  /// In the child; takes neither memory nor locks.
  void hand_over() const {
    for (const auto& [copy, there] : pairs_) ::dup2(copy, there);
  }

 private:
  std::vector<std::pair<int, int>> pairs_;
};

}  // namespace

Pipe::Pipe() {
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) == 0) {
    reading_ = ::fcntl(ends[0], F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    writing_ = ::fcntl(ends[1], F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    const int failure = errno;
    ::close(ends[0]);
    ::close(ends[1]);
    errno = failure;
  }
  if (reading_ >= 0 && writing_ >= 0) return;
  const std::string reason = std::strerror(errno);
  ::close(reading_);
  throw Error(fmt::format("cannot make a pipe to another process: {}", reason), 4);
}

Pipe::~Pipe() {
  ::close(reading_);
  close_writing_end();
}

void Pipe::close_writing_end() {
  if (writing_ >= 0) ::close(writing_);
  writing_ = -1;
}

ChildProcess::ChildProcess(const ChildSetup& setup) {
  std::vector<std::string> words{setup.program.string()};
  words.insert(words.end(), setup.arguments.begin(), setup.arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  const Copies copies(setup);
  if (!copies.are_made() || ::access(setup.program.c_str(), X_OK) != 0)
    throw SolverError(fmt::format("cannot start '{}': {}", setup.program.string(), std::strerror(errno)));
  sigset_t no_signals;
  sigemptyset(&no_signals);
  const pid_t parent = ::getpid();
  // Handlers of this process must not take what is meant for the program that replaces it.
  const BlockedSignals until_handled_again;
  process_ = ::fork();
  if (process_ == 0) {
    // Between fork and exec nothing that takes memory or locks.
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, setup.signal_at_death);
    if (::getppid() != parent) ::_exit(0);  // it died before it could be watched
    copies.hand_over();
    // What this process blocks just now must end the child all the same.
    if (!setup.lets_signals_through) ::sigprocmask(SIG_SETMASK, &no_signals, nullptr);
    ::execv(setup.program.c_str(), pointers.data());
    ::_exit(127);
  }
  if (process_ < 0)
    throw SolverError(fmt::format("cannot start '{}': {}", setup.program.string(), std::strerror(errno)));
  ::setpgid(process_, process_);  // here too: kill() may come before the child has done it
}

ChildProcess::~ChildProcess() {
  if (poll()) return;
  interrupt();
  wait();
}

std::optional<int> ChildProcess::poll() {
  int status = 0;
  if (!status_ && ::waitpid(process_, &status, WNOHANG) == process_) status_ = exit_status(status);
  return status_;
}

int ChildProcess::wait() {
  int status = 0;
  while (!status_) {
    if (::waitpid(process_, &status, 0) == process_)
      status_ = exit_status(status);
    else if (errno != EINTR)
      status_ = 127;
  }
  return *status_;
}

void ChildProcess::interrupt() {
  if (!status_) ::kill(process_, SIGINT);
}

void ChildProcess::kill() {
  if (!status_) ::kill(-process_, SIGKILL);
}

}  // namespace creepcontact::platform
