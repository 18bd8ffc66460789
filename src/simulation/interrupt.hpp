#pragma once
/// SIGINT, SIGTERM and SIGHUP as a flag that the time loop looks at.

#include <csignal>

namespace creepcontact::simulation {

/// Catches the signals for its own life; a second signal has its usual effect.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  bool requested() const;

 private:
  struct sigaction old_int_ {
  }, old_term_{}, old_hup_{};
};

}  // namespace creepcontact::simulation
