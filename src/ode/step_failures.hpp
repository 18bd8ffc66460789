#pragma once
/// What the integrators of this project do where no rate, no step or no interpolation is possible.

#include <string>

#include "creepcontact/base/error.hpp"
#include "creepcontact/ode/integrator.hpp"

namespace creepcontact::ode {

/// @throws SolverError: the creep rate cannot be computed at the start
[[noreturn]] void fail_at_start(const Integrator& of, double t, const RecoverableError& why);

/// Runs `evaluate`, the first work at t. @throws SolverError for its RecoverableError
template <typename Evaluate>
void at_start(const Integrator& of, double t, const Evaluate& evaluate) {
  try {
    evaluate();
  } catch (const RecoverableError& error) {
    fail_at_start(of, t, error);
  }
}

/// @throws std::out_of_range if t is not in the last step, which began at `begin`
void require_in_last_step(const Integrator& of, double t, double begin);

/// Counts the attempts to make one step under error control, and gives up where there were too many.
class StepAttempts {
 public:
  /// @param of, counters  must outlive the object
  StepAttempts(const Integrator& of, Integrator::Counters& counters) : of_(of), counters_(counters) {}

  int count() const { return count_; }  ///< 1 in the first attempt
  /// Before the first attempt. @throws SolverError if h does not move the time: the rate grows without bound
  void begin(double h) const;
  /// The local error was `error` times the one allowed.
  void rejected(double error);
  void failed(const RecoverableError& why);
  /// Begins the next attempt. @param h  its step
  /// @throws SolverError with the last reason after 30 attempts, or if h is vanishingly short
  void again(double h);

 private:
  const Integrator& of_;
  Integrator::Counters& counters_;
  int count_ = 1;
  std::string reason_;
};

}  // namespace creepcontact::ode
