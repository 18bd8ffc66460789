#pragma once
/// What SIGINT, SIGTERM and SIGHUP do: they end the process at once while it has nothing to save, and are a request to
/// come to an end while it has.

#include <csignal>

namespace creepcontact::platform {

/// Exit status of a process that a signal has ended.
constexpr int interrupted_status = 130;

/// To be called first in main: from here on such a signal ends the process with a sentence on standard error and
/// status 130. A SIGHUP that is ignored (nohup) stays so; signals that were blocked before the program was started are
/// let through, and a SIGCHLD that was ignored is not.
void end_at_signals();

/// Blocks the signals for its life, in this thread and in the processes that are made meanwhile. A program that calls
/// end_at_signals() and is started so misses none of them, however early they come.
class BlockedSignals {
 public:
  BlockedSignals();
  ~BlockedSignals();
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;

 private:
  sigset_t before_;
};

/// While one lives, a signal is a request that the owner looks at; the same signal once more ends the process at once.
/// The handlers found by the first one come back when the last one is gone. For one thread.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  /// Since the first of those that live now.
  bool requested() const;
};

/// While one lives, a signal that would end the process at once waits: a file is being put into its place.
class DelayedSignals {
 public:
  DelayedSignals();
  ~DelayedSignals();
  DelayedSignals(const DelayedSignals&) = delete;
  DelayedSignals& operator=(const DelayedSignals&) = delete;
};

}  // namespace creepcontact::platform
