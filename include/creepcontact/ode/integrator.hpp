#pragma once
/// Time integration behind one interface: the article's Euler schemes and SUNDIALS.

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "creepcontact/ode/system.hpp"

namespace creepcontact::ode {

/// What an accepted step was like.
struct StepReport {
  double time = 0;  ///< at its end
  double step = 0;
  int order = 0;
  double error_estimate = 0;  ///< in units of what the tolerance allows a step; 0 if the method has none
};

enum class StepMode {
  fixed,
  stable,
  adaptive,
  to_limit  ///< every step goes to the limit given: whoever calls decides
};

/// How long the steps of the Euler schemes are.
struct StepChoice {
  StepMode mode = StepMode::stable;
  double length = 0;  ///< fixed

  StepChoice() = default;
  // A mode or a length is a choice.
  StepChoice(StepMode how) : mode(how) {}                             // NOLINT(google-explicit-constructor)
  StepChoice(double fixed) : mode(StepMode::fixed), length(fixed) {}  // NOLINT(google-explicit-constructor)
};

/// How beta_euler solves for the new state.
enum class InnerIteration { fixed_point, newton };

/// How implicit methods solve their Newton systems: GMRES with System::jacobian_times, or System::solve_tangent.
enum class LinearSolver { krylov, tangent };

/// Settings of all integrators, each using its own; defaults are the configuration's.
struct IntegratorOptions {
  double tolerance = 1e-4;             ///< relative accuracy; absolute tolerance = tolerance * System::scale()
  StepChoice step = StepMode::stable;  ///< Euler: fixed, the stable step times step_factor, or under error control
  double step_factor = 1.0;
  double beta = 1.0;  ///< beta_euler, >= 0.5
  InnerIteration inner = InnerIteration::fixed_point;
  double inner_tolerance = 1e-10;    ///< beta_euler: bound on the maximum creep-strain change of the inner iterations
  int max_inner_iterations = 200;    ///< beta_euler
  int inner_anderson = 0;            ///< beta_euler: depth of Anderson acceleration of the inner iterations; 0: plain
  double residual_correction = 0.0;  ///< gamma of the nodal-force residual (Euler schemes)
  LinearSolver linear_solver = LinearSolver::krylov;  ///< cvode_bdf, arkode_dirk
  std::string table = {};     ///< ARKODE: name of a Butcher table with an embedded method; empty: the default
  double end_time = 0;        ///< end of the run, bounds the first step
  int restart_interval = 20;  ///< ARKODE: steps from one restart point to the next
};

/// All that the steps to come depend on, as a checkpoint keeps it.
struct RestartPoint {
  double time = 0;
  double next_step = 0;
  std::vector<double> state;
  std::map<std::string, std::vector<double>> memory;  ///< the method's own; names are those of its members
};

class Integrator {
 public:
  virtual ~Integrator() = default;
  virtual std::string name() const = 0;
  /// The integrator at work: name(), unless this one hands the steps to others.
  virtual std::string method() const { return name(); }

  /// Starts (or starts anew after a jump) from (t, y).
  /// @param step  proposed first step, 0: let the integrator choose
  virtual void initialize(double t, std::span<const double> y, double step = 0) = 0;

  /// True if the state jumps where loads do: initialize() then finds that after the jump.
  virtual bool jumps_with_loads() const { return false; }

  /// One accepted step; never goes beyond t_limit, ends on it exactly if it gets there.
  /// @throws SolverError with advice if no step can be made; state() is then the last accepted one.
  virtual StepReport step(double t_limit) = 0;

  /// True if interpolate() is as accurate as the method: output times then need no step of their own.
  virtual bool interpolates() const { return false; }
  /// State at t within the last step. @param y size of the system
  virtual void interpolate(double t, std::span<double> y) const = 0;

  virtual double time() const = 0;
  virtual std::span<const double> state() const = 0;
  virtual double next_step() const = 0;  ///< proposal for the next step (restart)

  /// True after the steps (and initialize()) from whose end save() and restore() can take the integration up again.
  virtual bool at_restart_point() const { return true; }
  /// True if all steps end at such a point.
  virtual bool restarts_after_every_step() const { return true; }
  /// True if a restored integrator makes the very steps, to the last bit, that the saved one makes after save(); false:
  /// the same within the tolerance.
  virtual bool restores_exactly() const { return false; }
  /// The end of the last step, a restart point. Methods with a memory of their own add it to `memory`.
  virtual RestartPoint save() const;
  /// In place of initialize(). @throws std::out_of_range if the point lacks what the method keeps (another one's)
  virtual void restore(const RestartPoint& point);

  struct Counters {
    std::int64_t steps = 0;
    std::int64_t rejected_steps = 0;        ///< error test
    std::int64_t convergence_failures = 0;  ///< nonlinear iteration
  };
  virtual Counters counters() const = 0;  ///< since construction, over all initialize() calls
};

struct IntegratorInfo {
  std::string name;
  std::string description;
  std::unique_ptr<Integrator> (*make)(System& system, const IntegratorOptions& options);
  std::vector<std::string> tables = {};  ///< that IntegratorOptions::table may name
  bool isochronous = false;              ///< rate() is taken for the state itself: y(t) = f(t, y(t))
};

/// All integrators, by name: what a configuration may ask for.
const std::vector<IntegratorInfo>& integrators();
/// For systems whose rate may start singular, the integrator works in a time in which it does not (SingularStart).
/// @throws std::out_of_range if there is none of this name
std::unique_ptr<Integrator> make_integrator(const std::string& name, System& system, const IntegratorOptions& options);

}  // namespace creepcontact::ode
