#pragma once
/// Child processes: programs that this one starts and waits for.

#include <sys/types.h>

#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace creepcontact::platform {

/// A pipe between processes. A started program inherits an end only if it is named in ChildSetup. The ends are never
/// one of the standard descriptors 0 to 2, even where those are closed.
class Pipe {
 public:
  /// @throws Error (exit status 4) if the system provides none
  Pipe();
  ~Pipe();
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int reading_end() const { return reading_; }
  int writing_end() const { return writing_; }
  /// Readers then see the end of the data when the last other process has closed its writing end.
  void close_writing_end();

 private:
  int reading_ = -1, writing_ = -1;
};

/// All that is written into the pipe until its writers have ended.
std::string read_to_end(const Pipe& pipe);

/// The program of this name in the directories of PATH that are given by absolute paths: not in the working directory,
/// whose files may be a stranger's; empty if there is none.
std::filesystem::path find_on_path(const std::string& name);

/// What to start, and how.
struct ChildSetup {
  std::filesystem::path program;  ///< a path; PATH is not searched
  std::vector<std::string> arguments = {};
  /// Descriptors passed on: (number here, number there). Standard input, output and error are /dev/null unless named.
  std::vector<std::pair<int, int>> descriptors = {};
  int signal_at_death = SIGTERM;  ///< sent to it if the thread that started it ends first
  /// True if the program calls end_at_signals(). It is then started with the signals blocked, so that it misses none.
  bool lets_signals_through = false;
  std::filesystem::path directory = {};  ///< where it is started; empty: that of this process
};

/// A running or finished child process.
class ChildProcess {
 public:
  /// Starts the program in its own process group: signals from the terminal reach it only if this process passes them
  /// on.
  /// @throws SolverError if it cannot be started
  explicit ChildProcess(const ChildSetup& setup);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  /// Sends SIGINT if it still runs, and waits for it.
  ~ChildProcess();

  /// Exit status: 128 + signal if a signal ended it, 127 if the system does not tell (SIGCHLD is ignored); nullopt
  /// while it runs. Returns at once.
  std::optional<int> poll();
  /// Waits for its end. @returns the exit status as poll()
  int wait();
  /// Sends SIGINT.
  void interrupt();
  /// Sends SIGKILL to its process group.
  void kill();

 private:
  void wait_for_status(int options);

  pid_t process_ = 0;
  std::optional<int> status_;
};

}  // namespace creepcontact::platform
