#pragma once
/// One step at a time through CVODE or ARKODE: limits, errors, counters and weights, which are alike in both.

#include <string>
#include <sundials/sundials_context.hpp>

#include "creepcontact/ode/integrator.hpp"
#include "sundials_callbacks.hpp"
#include "sundials_vector.hpp"

namespace creepcontact::ode {

/// Weights: those of set_error_weights(), taken again after every step.
class SundialsIntegrator : public Integrator {
 public:
  std::string name() const final { return name_; }
  /// Forgets the history: the method starts from its lowest order or, if step = 0, searches for a first step.
  void initialize(double t, std::span<const double> y, double step = 0) final;
  StepReport step(double t_limit) final;
  bool interpolates() const final { return true; }
  void interpolate(double t, std::span<double> y) const final;
  double time() const final { return time_; }
  std::span<const double> state() const final { return view(state_.get(), system_.size()); }
  double next_step() const final { return proposal_; }
  Counters counters() const final;
  bool at_restart_point() const final;
  bool restarts_after_every_step() const final { return restart_interval() <= 1; }
  bool restores_exactly() const final { return restart_interval() > 0; }
  void restore(const RestartPoint& point) final;

 protected:
  /// @throws ConfigError if the tolerance is not positive
  SundialsIntegrator(std::string name, System& system, const IntegratorOptions& options);

  /// Counters since restart(), and the last step.
  struct Statistics {
    long steps = 0, rejected = 0, convergence_failures = 0;
    int order = 0;
    double next_step = 0;
  };
  // The two packages. Functions that return int return the package's flag.
  virtual void restart(double t, N_Vector y, double first_step) = 0;
  virtual int set_stop(double t) = 0;
  virtual int set_smallest_step(double step) = 0;
  /// One internal step into y. @param horizon  bounds the search for the first step
  virtual int evolve(double horizon, N_Vector y, double& t) = 0;
  virtual int interpolate_into(double t, N_Vector y) const = 0;
  virtual int local_errors(N_Vector errors) const = 0;
  virtual double internal_time() const = 0;
  virtual Statistics statistics() const = 0;
  /// The memory of a package cannot be read, but it can be dropped: after so many steps the method begins again from
  /// the state and the proposed step alone, in every run, so that a restored one computes the same. 0: never.
  virtual int restart_interval() const { return 0; }

  /// @throws std::runtime_error naming the function if the flag of a SUNDIALS call is an error
  static void check(int flag, const char* function);

  const IntegratorOptions options_;
  sundials::Context context_;  // outlives whatever is made from it
  SundialsCallbacks callbacks_;
  Vector state_;  ///< y at time_, padded to one entry if the system is empty

 private:
  void begin_anew(double step);
  void take_weights();
  void limit(double t_limit);
  int evolve_with_retries(double t_limit, double& t);
  double horizon(double t_limit) const;
  std::string advice(int flag) const;

  std::string name_;
  System& system_;
  Vector work_;     ///< where the next state is made: state_ stays whole if the step fails
  Vector weights_;  ///< 1 / absolute tolerance
  double time_ = 0;
  double begin_ = 0;  ///< of the last step
  double proposal_ = 0;
  bool stop_set_ = false;
  int steps_since_restart_ = 0;
  bool begun_ = false;
  bool rate_has_jumped_ = false;  ///< after the last step: explicit methods carry its rate on
  int careful_steps_ = 0;         ///< still to be made with the smaller tolerance of a new start
  Counters before_;               ///< of all restarts before the last
};

}  // namespace creepcontact::ode
