#include "child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/interrupt.hpp"

namespace creepcontact::simulation {
namespace {

int exit_status(int wait_status) {
  return WIFSIGNALED(wait_status) ? 128 + WTERMSIG(wait_status) : WEXITSTATUS(wait_status);
}

}  // namespace

ChildProcess::ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                           const std::filesystem::path& log) {
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  const int output = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  const int input = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (output < 0 || ::access(program.c_str(), X_OK) != 0) {
    const std::string reason = std::strerror(errno);
    if (output >= 0) ::close(output);
    ::close(input);
    throw SolverError(
        fmt::format("cannot start '{}' with its log in '{}': {}", program.string(), log.string(), reason));
  }
  const pid_t parent = ::getpid();
  // Handlers of this process must not take what is meant for the program that replaces it.
  const BlockedSignals until_handled_again;
  process_ = ::fork();
  if (process_ == 0) {
    // Between fork and exec nothing that takes memory or locks.
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != parent) ::_exit(0);  // it died before it could be watched
    ::dup2(input, STDIN_FILENO);
    ::dup2(output, STDOUT_FILENO);
    ::dup2(output, STDERR_FILENO);
    ::execv(program.c_str(), pointers.data());
    ::_exit(127);
  }
  const int failure = errno;
  ::close(output);
  ::close(input);
  if (process_ < 0) throw SolverError(fmt::format("cannot start '{}': {}", program.string(), std::strerror(failure)));
}

ChildProcess::~ChildProcess() {
  if (poll()) return;
  interrupt();
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
}

std::optional<int> ChildProcess::poll() {
  int status = 0;
  if (!status_ && waitpid(process_, &status, WNOHANG) == process_) status_ = exit_status(status);
  return status_;
}

void ChildProcess::interrupt() {
  if (!status_) kill(process_, SIGINT);
}

}  // namespace creepcontact::simulation
