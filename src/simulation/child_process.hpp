#pragma once
/// A process of a program that this one starts and waits for.

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace creepcontact::simulation {

class ChildProcess {
 public:
  /// Starts it in a process group of its own: signals of the terminal reach it through interrupt() alone, once.
  /// Should this process die, it is sent SIGTERM.
  /// @param log  file for what it prints, replaced
  /// @throws SolverError if it cannot be started
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
               const std::filesystem::path& log);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  /// Interrupts it if it still runs, and waits for it.
  ~ChildProcess();

  /// Its exit status, 128 + signal if one ended it; nullopt while it runs. Returns at once.
  std::optional<int> poll();
  /// SIGINT
  void interrupt();

 private:
  pid_t process_ = 0;
  std::optional<int> status_;
};

}  // namespace creepcontact::simulation
