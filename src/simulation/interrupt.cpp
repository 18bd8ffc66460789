#include "interrupt.hpp"

namespace creepcontact::simulation {
namespace {

volatile std::sig_atomic_t caught = 0;

extern "C" void catch_signal(int) {
  caught = 1;
}

}  // namespace

Interrupt::Interrupt() {
  caught = 0;
  struct sigaction action {};
  action.sa_handler = catch_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, &old_int_);
  sigaction(SIGTERM, &action, &old_term_);
  // A terminal that is closed, a connection that is lost; nohup asks to ignore that.
  sigaction(SIGHUP, nullptr, &old_hup_);
  if (old_hup_.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
}

Interrupt::~Interrupt() {
  sigaction(SIGINT, &old_int_, nullptr);
  sigaction(SIGTERM, &old_term_, nullptr);
  sigaction(SIGHUP, &old_hup_, nullptr);
}

bool Interrupt::requested() const {
  return caught != 0;
}

}  // namespace creepcontact::simulation
