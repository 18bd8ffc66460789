#pragma once
/// The processes that run this program together: one, or in creepcontact-mpi those that mpirun has started.

#include <memory>
#include <string>

#include "creepcontact/run/run.hpp"

namespace creepcontact::cli {

/// How a process ends.
struct Ending {
  int status = 0;
  std::string message = {};  ///< of the error; empty: none, or it has been printed
};

/// One object per program, made before anything else that takes part in the work. Each program has its own
/// implementation (src/serial, src/parallel).
class Processes {
 public:
  Processes(int& argc, char**& argv);
  ~Processes();
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  /// As users call the program.
  static const char* program();
  /// True in the process that prints, and executes what one alone can do.
  static bool is_first();
  /// What run::run() needs to know of them. Precondition: the object exists
  static run::Processes of_run();
  /// What run::run() needs to know if is_first() executes the command alone. Precondition: the object exists
  static run::Processes of_one();
  /// True if all processes execute the command together; else is_first() does.
  /// @throws ConfigError if several processes, or this program, cannot execute it
  static bool share(const std::string& command);
  /// Threads that each process may use.
  static int threads(int cores);

  /// Waits for the others. If a process has failed while others wait for it, ends all of them.
  /// @returns how they have ended together: an error is that of one of them
  Ending end(const Ending& own);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace creepcontact::cli
