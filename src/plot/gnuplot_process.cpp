#include "gnuplot_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "creepcontact/base/error.hpp"

extern char** environ;

namespace creepcontact::plot {
namespace {

/// What a child is given: its directory, no input, its messages into a pipe.
class Wiring {
 public:
  explicit Wiring(const std::filesystem::path& directory) {
    if (::pipe2(pipe_.data(), O_CLOEXEC) != 0)
      throw Error(fmt::format("cannot run gnuplot: {}", std::strerror(errno)), 4);
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_addchdir_np(&actions_, directory.c_str());
    ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions_, pipe_[1], STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions_, pipe_[1], STDERR_FILENO);
  }
  ~Wiring() {
    ::posix_spawn_file_actions_destroy(&actions_);
    ::close(pipe_[0]);
    if (pipe_[1] >= 0) ::close(pipe_[1]);
  }
  Wiring(const Wiring&) = delete;
  Wiring& operator=(const Wiring&) = delete;

  const posix_spawn_file_actions_t* actions() const { return &actions_; }

  /// All that the child writes until it ends.
  std::string messages() {
    ::close(pipe_[1]);
    pipe_[1] = -1;
    std::string text;
    std::array<char, 4096> buffer;
    for (;;) {
      const ssize_t count = ::read(pipe_[0], buffer.data(), buffer.size());
      if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
      if (count == 0 || (count < 0 && errno != EINTR)) return text;
    }
  }

 private:
  std::array<int, 2> pipe_{};
  posix_spawn_file_actions_t actions_{};
};

std::string without_blank_ends(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \n"), end = text.find_last_not_of(" \n");
  return begin == std::string::npos ? "it says nothing" : text.substr(begin, end - begin + 1);
}

}  // namespace

void run_gnuplot(const std::filesystem::path& directory, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"gnuplot", "--default-settings"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  Wiring wiring(directory);
  pid_t child = 0;
  const int failure = ::posix_spawnp(&child, argv[0], wiring.actions(), nullptr, argv.data(), environ);
  if (failure == ENOENT)
    throw ConfigError(
        "pictures are drawn by gnuplot, which was not found on the PATH; install it (Debian: apt-get "
        "install gnuplot-nox)");
  if (failure != 0) throw Error(fmt::format("cannot run gnuplot: {}", std::strerror(failure)), 4);
  const std::string messages = wiring.messages();
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw Error(fmt::format("gnuplot failed in '{}': {}", directory.string(), without_blank_ends(messages)), 4);
}

}  // namespace creepcontact::plot
