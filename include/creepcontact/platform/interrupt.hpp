#pragma once
/// Handling of SIGINT, SIGTERM and SIGHUP. While the process has nothing to save, they end it at once; otherwise they
/// are a request to finish.

#include <csignal>

namespace creepcontact::platform {

/// Exit status of a process ended by one of these signals.
constexpr int interrupted_status = 130;

/// To be called first in main. From then on such a signal ends the process with a message on standard error and status
/// 130. An ignored SIGHUP (nohup) stays ignored; signals blocked before the program was started are unblocked, and an
/// ignored SIGCHLD is reset to its default. SIGXFSZ is ignored: a write beyond the limit of the size of files (ulimit
/// -f) fails, as on a full disk.
void end_at_signals();

/// Blocks the signals while it lives, in this thread and in processes started meanwhile. A program started in this way
/// that calls end_at_signals() misses no signal, however early.
class BlockedSignals {
 public:
  BlockedSignals();
  ~BlockedSignals();
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;

 private:
  sigset_t before_;
};

/// While an object of this class lives, a signal is a request that the owner polls; the same signal once more ends the
/// process at once. The first object replaces the handlers, the last one restores them. Each object belongs to one
/// thread; several threads may have their own, which all get the request.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  /// True if a signal has arrived since the first of the living objects was made.
  bool requested() const;
};

/// While one lives, a signal that would end the process is delayed, so that a file can be moved into place.
class DelayedSignals {
 public:
  DelayedSignals();
  ~DelayedSignals();
  DelayedSignals(const DelayedSignals&) = delete;
  DelayedSignals& operator=(const DelayedSignals&) = delete;
};

}  // namespace creepcontact::platform
