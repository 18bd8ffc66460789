#pragma once
/// A system of ordinary differential equations dy/dt = f(t, y) as the integrators see it: what each of them needs
/// (System), and what some can make use of where it is offered.

#include <cstdint>
#include <span>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/team.hpp"

namespace creepcontact::ode {

/// Products with the Jacobian and a preconditioner, for Krylov methods.
class JacobianProducts {
 public:
  virtual ~JacobianProducts() = default;
  /// product = (df/dy)(t, y) v. Called at the point of the last rate() as a rule; another point is evaluated first.
  virtual void jacobian_times(double t, std::span<const double> y, std::span<const double> v,
                              std::span<double> product) = 0;
  /// Keeps what precondition() needs about the point (t, y); the point of the last rate() as a rule.
  virtual void prepare_preconditioner(double t, std::span<const double> y) = 0;
  /// z = (I - gamma J_local)^-1 r, J_local the point-wise part of df/dy at the prepared point.
  virtual void precondition(double gamma, std::span<const double> r, std::span<double> z) = 0;
};

/// Newton systems solved directly.
class NewtonSolver {
 public:
  virtual ~NewtonSolver() = default;
  /// Factors I - gamma J at the point (t, y) for solve_tangent(); the point of the last rate() as a rule.
  /// @throws RecoverableError, as where the matrix is singular
  virtual void prepare_tangent(double t, std::span<const double> y, double gamma) = 0;
  /// z = (I - gamma J)^-1 r with gamma and J of the last prepare_tangent(), but for what of J may follow the last
  /// rate() at no cost. @throws RecoverableError
  virtual void solve_tangent(std::span<const double> r, std::span<double> z) = 0;
};

/// Rates that are infinite where loads begin or jump.
class SingularRate {
 public:
  virtual ~SingularRate() = default;
  /// y is smooth in (t' - t)^exponent from t on; 1: the rate is finite.
  virtual double start_exponent(double t, std::span<const double> y) = 0;
  /// Change of y from (t, y) on over `duration`, by the closed forms of what is singular there, at the stress that y
  /// has at `stress_time` and that stays as it is. @throws RecoverableError
  virtual void start_increment(double t, std::span<const double> y, double stress_time, double duration,
                               std::span<double> change) = 0;
};

/// f is a pure function of (t, y): what accept() stores may change the cost of an evaluation, not its value.
class System {
 public:
  virtual ~System() = default;
  /// Of the part of the state that this process holds: all spans below have this length.
  virtual std::size_t size() const = 0;
  /// The processes that hold the parts of the state; norms are those of all of it.
  virtual const Team& team() const { return serial_team(); }

  /// rate = f(t, y). @throws RecoverableError; any other exception ends the run.
  virtual void rate(double t, std::span<const double> y, std::span<double> rate) = 0;

  /// Largest step at which explicit Euler is stable at (t, y) (Cormeau 1975); infinity if nothing creeps.
  virtual double stable_step(double t, std::span<const double> y) = 0;

  /// Error of y_i that the user takes for one unit of relative accuracy: absolute tolerance = tolerance * scale()[i].
  /// May change with accept().
  virtual std::span<const double> scale() const = 0;

  /// (t, y) is an accepted step: warm starts are taken from here.
  virtual void accept(double t, std::span<const double> y) = 0;
  /// Evaluations made so far must not be handed out again: those to come then depend, to the last bit, on what accept()
  /// has stored alone. Integrators call it where they begin anew.
  virtual void forget_evaluations() {}

  // What is not offered is null.
  virtual JacobianProducts* jacobian() { return nullptr; }
  virtual NewtonSolver* newton_solver() { return nullptr; }
  virtual SingularRate* singular_rate() { return nullptr; }

  /// Of all that was asked so far.
  struct Counters {
    std::int64_t rate_evaluations = 0;
    std::int64_t jacobian_products = 0;
  };
  virtual Counters counters() const = 0;
};

}  // namespace creepcontact::ode
