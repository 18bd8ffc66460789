#include "creepcontact/platform/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/process/args.hpp>
#include <boost/process/child.hpp>
#include <boost/process/error.hpp>
#include <boost/process/exe.hpp>
#include <boost/process/extend.hpp>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sstream>

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

/// What happens around the fork, on both sides.
class Setup : public boost::process::extend::handler {
 public:
  Setup(const ChildSetup& setup, const Copies& copies) : setup_(setup), copies_(copies) { sigemptyset(&no_signals_); }

  /// In the child. Between fork and exec nothing that takes memory or locks.
  template <typename Executor>
  void on_exec_setup(Executor&) const {
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, setup_.signal_at_death);
    if (::getppid() != parent_) ::_exit(0);  // it died before it could be watched
    if (!setup_.directory.empty() && ::chdir(setup_.directory.c_str()) != 0) ::_exit(127);
    ::signal(SIGXFSZ, SIG_DFL);  // it is ignored here alone
    copies_.hand_over();
    // What this process blocks just now must still end the child.
    if (!setup_.lets_signals_through) ::sigprocmask(SIG_SETMASK, &no_signals_, nullptr);
  }
  template <typename Executor>
  void on_exec_error(Executor&, const std::error_code&) const {
    ::_exit(127);
  }
  template <typename Executor>
  void on_fork_error(Executor&, const std::error_code& error) const {
    throw SolverError(fmt::format("cannot start '{}': {}", setup_.program.string(), error.message()));
  }
  template <typename Executor>
  void on_success(Executor& executor) const {
    ::setpgid(executor.pid, executor.pid);  // here too: kill() may come before the child has done it
  }

 private:
  const ChildSetup& setup_;
  const Copies& copies_;
  pid_t parent_ = ::getpid();
  sigset_t no_signals_;
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

std::string read_to_end(const Pipe& pipe) {
  std::string text;
  std::array<char, 4096> buffer;
  for (;;) {
    const ssize_t count = ::read(pipe.reading_end(), buffer.data(), buffer.size());
    if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
    if (count == 0 || (count < 0 && errno != EINTR)) return text;
  }
}

std::filesystem::path find_on_path(const std::string& name) {
  const char* all = std::getenv("PATH");
  std::istringstream places(all == nullptr ? "/usr/local/bin:/usr/bin:/bin" : all);
  for (std::string place; std::getline(places, place, ':');) {
    if (!place.starts_with('/')) continue;
    std::filesystem::path program = std::filesystem::path(place) / name;
    std::error_code failure;
    if (std::filesystem::is_regular_file(program, failure) && ::access(program.c_str(), X_OK) == 0) return program;
  }
  return {};
}

ChildProcess::ChildProcess(const ChildSetup& setup) {
  const Copies copies(setup);
  if (!copies.are_made() || ::access(setup.program.c_str(), X_OK) != 0)
    throw SolverError(fmt::format("cannot start '{}': {}", setup.program.string(), std::strerror(errno)));
  // Handlers of this process must not take what is meant for the program that replaces it.
  const BlockedSignals until_handled_again;
  namespace process = boost::process;
  // Told to ignore errors, which Setup reports: else Boost watches the exec through a pipe that whatever another thread
  // starts meanwhile inherits.
  process::child child(process::exe = setup.program.string(), process::args = setup.arguments, Setup(setup, copies),
                       process::ignore_error);
  process_ = child.id();
  child.detach();
}

ChildProcess::~ChildProcess() {
  if (poll()) return;
  interrupt();
  wait();
}

std::optional<int> ChildProcess::poll() {
  wait_for_status(WNOHANG);
  return status_;
}

int ChildProcess::wait() {
  wait_for_status(0);
  return *status_;
}

/// Waits by hand: boost::process::child takes a status that the system has thrown away (SIGCHLD ignored) for success.
void ChildProcess::wait_for_status(int options) {
  constexpr int unknown = 127;
  while (!status_) {
    int status = 0;
    const pid_t found = ::waitpid(process_, &status, options);
    if (found == 0) return;
    if (found == process_)
      status_ = exit_status(status);
    else if (errno != EINTR)
      status_ = unknown;
  }
}

void ChildProcess::interrupt() {
  if (!status_) ::kill(process_, SIGINT);
}

void ChildProcess::kill() {
  if (!status_) ::kill(-process_, SIGKILL);
}

}  // namespace creepcontact::platform
