#pragma once
/// A process of a program that this one starts and waits for.

#include <sys/types.h>

#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace creepcontact::platform {

/// A pipe whose ends no started program inherits unless it is named to it; never one of the standard descriptors, not
/// even where those are closed.
class Pipe {
 public:
  /// @throws Error (exit status 4) if the system gives none
  Pipe();
  ~Pipe();
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int reading_end() const { return reading_; }
  int writing_end() const { return writing_; }
  /// The reading end then comes to its end when the last other process has closed its own.
  void close_writing_end();

 private:
  int reading_ = -1, writing_ = -1;
};

struct ChildSetup {
  std::filesystem::path program;  ///< a path, not searched for
  std::vector<std::string> arguments = {};
  /// Descriptors it gets: (here, there). Standard input, output and error are /dev/null where not named.
  std::vector<std::pair<int, int>> descriptors = {};
  int signal_at_death = SIGTERM;  ///< sent to it should this thread die
  /// It calls end_at_signals(), and so is started with the signals blocked: it misses none.
  bool lets_signals_through = false;
};

class ChildProcess {
 public:
  /// Starts it in a process group of its own: signals of the terminal reach it through this process alone.
  /// @throws SolverError if it cannot be started
  explicit ChildProcess(const ChildSetup& setup);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  /// Interrupts it if it still runs, and waits for it.
  ~ChildProcess();

  /// Its exit status, 128 + signal if one ended it, 127 if the system does not tell (SIGCHLD is ignored); nullopt while
  /// it runs. Returns at once.
  std::optional<int> poll();
  /// Waits for its end. @returns as poll
  int wait();
  /// SIGINT
  void interrupt();
  /// SIGKILL, to all of its process group.
  void kill();

 private:
  void look(int options);

  pid_t process_ = 0;
  std::optional<int> status_;
};

}  // namespace creepcontact::platform
