#pragma once
/// Time integrators behind one interface: Euler schemes (Stankevich 2012), LogAdams, and SUNDIALS.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "creepcontact/base/memory.hpp"
#include "creepcontact/ode/system.hpp"
#include "creepcontact/settings/integrator_options.hpp"

namespace creepcontact::ode {

/// Properties of one accepted step.
struct StepReport {
  double time = 0;  ///< at its end
  double step = 0;
  int order = 0;
  double error_estimate = 0;  ///< in units of the error allowed per step; 0 if the method has no estimate
};

using settings::InnerIteration;
using settings::IntegratorOptions;
using settings::LinearSolver;
using settings::StepChoice;
using settings::StepMode;

/// Everything that later steps depend on, as stored in a checkpoint.
struct RestartPoint {
  double time = 0;
  double next_step = 0;
  std::vector<double> state;
  Memory memory;  ///< of the method itself; named after its members
  /// Likewise, but vectors of the size of the state, one or several in turn: each process has its part of them, under
  /// the same names.
  Memory states = {};
};

/// An integrator at some (t, y). It refers to a System, which must outlive it. Use from one thread at a time;
/// initialize(), step() and restore() are collective.
class Integrator {
 public:
  virtual ~Integrator() = default;
  virtual std::string name() const = 0;
  /// Name of the integrator at work; differs from name() if this one delegates its steps.
  virtual std::string method() const { return name(); }

  /// Starts from (t, y), or restarts there after a jump of the loads.
  /// @param step  proposed first step; 0: the integrator chooses
  virtual void initialize(double t, std::span<const double> y, double step = 0) = 0;

  /// True if the state jumps where the loads do; initialize() then computes the state after the jump.
  virtual bool jumps_with_loads() const { return false; }

  /// Makes one accepted step. It never passes t_limit, and ends exactly there if it reaches it.
  /// @throws SolverError with advice if no step can be made; state() is then the last accepted one
  virtual StepReport step(double t_limit) = 0;

  /// True if interpolate() is as accurate as the method; output times then need no steps that end on them.
  virtual bool interpolates() const { return false; }
  /// State at time t within the last step. @param y  of System::size() @throws std::out_of_range if t is outside of it
  virtual void interpolate(double t, std::span<double> y) const = 0;

  /// Time and state after the last accepted step; the span is valid until the next step.
  virtual double time() const = 0;
  virtual std::span<const double> state() const = 0;
  virtual double next_step() const = 0;  ///< proposed next step

  /// True if the integration can be resumed from here by save() and restore(): after initialize() and some or all
  /// steps.
  virtual bool at_restart_point() const { return true; }
  /// True if that holds after every step.
  virtual bool restarts_after_every_step() const { return true; }
  /// True if a restored integrator makes the same steps, to the last bit, as the saved one makes after save(); false:
  /// the same within the tolerance.
  virtual bool restores_exactly() const { return false; }
  /// The state at the end of the last step, which must be a restart point. Methods with more data add it to `memory`.
  virtual RestartPoint save() const;
  /// Replaces initialize(). @throws std::out_of_range if data of the method is missing, as in a point of another method
  virtual void restore(const RestartPoint& point);

  struct Counters {
    std::int64_t steps = 0;
    std::int64_t rejected_steps = 0;        ///< failed error tests
    std::int64_t convergence_failures = 0;  ///< failures of the nonlinear iteration
  };
  virtual Counters counters() const = 0;  ///< since construction, across initialize() calls
};

/// An entry of the list of integrators.
struct IntegratorInfo {
  std::string name;
  std::string description;
  std::unique_ptr<Integrator> (*make)(System& system, const IntegratorOptions& options);
  std::vector<std::string> tables = {};  ///< allowed values of IntegratorOptions::table
  bool isochronous = false;              ///< true if rate() is taken for the state itself: y(t) = f(t, y(t))
};

/// All integrators that a configuration may name.
const std::vector<IntegratorInfo>& integrators();
/// Makes an integrator by name. If the rate of the system may be infinite at the start (System::singular_rate), the
/// integrator is wrapped to work in a transformed time in which the rate is finite. @param system  must outlive the
/// result
/// @throws std::out_of_range if the name is unknown
std::unique_ptr<Integrator> make_integrator(const std::string& name, System& system, const IntegratorOptions& options);

}  // namespace creepcontact::ode
