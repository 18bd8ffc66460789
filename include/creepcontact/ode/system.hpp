#pragma once
/// A system of ordinary differential equations dy/dt = f(t, y) as the integrators see it: what all of them need
/// (System), and optional capabilities that some of them use.

#include <cstdint>
#include <limits>
#include <span>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/team.hpp"

namespace creepcontact::ode {

/// Products with the Jacobian and a preconditioner, for Krylov methods.
class JacobianProducts {
 public:
  virtual ~JacobianProducts() = default;
  /// product = (df/dy)(t, y) v. Usually called at the point of the last rate(); any other point is evaluated first.
  virtual void jacobian_times(double t, std::span<const double> y, std::span<const double> v,
                              std::span<double> product) = 0;
  /// Prepares precondition() for the point (t, y), usually that of the last rate().
  virtual void prepare_preconditioner(double t, std::span<const double> y) = 0;
  /// z = (I - gamma J_local)^-1 r, with J_local the point-wise part of df/dy at the prepared point.
  virtual void precondition(double gamma, std::span<const double> r, std::span<double> z) = 0;
  /// Both at once, for a single use of J_local: nothing need be stored.
  virtual void precondition_once(double t, std::span<const double> y, double gamma, std::span<const double> r,
                                 std::span<double> z) {
    prepare_preconditioner(t, y);
    precondition(gamma, r, z);
  }
};

/// Direct solution of Newton systems.
class NewtonSolver {
 public:
  virtual ~NewtonSolver() = default;
  /// Factors I - gamma J at the point (t, y), usually that of the last rate(), for solve_tangent().
  /// @throws RecoverableError, for example if the matrix is singular
  virtual void prepare_tangent(double t, std::span<const double> y, double gamma) = 0;
  /// z = (I - gamma J)^-1 r with gamma and J of the last prepare_tangent(). Parts of J that can be updated for free may
  /// follow the last rate(), such as the set of closed contacts. @throws RecoverableError
  virtual void solve_tangent(std::span<const double> r, std::span<double> z) = 0;
};

/// Closed forms for rates that are infinite where loads begin or jump.
class SingularRate {
 public:
  virtual ~SingularRate() = default;
  /// Exponent in (0, 1] for which y is a smooth function of (t' - t)^exponent for t' > t; 1: the rate is finite.
  virtual double start_exponent(double t, std::span<const double> y) = 0;
  /// change += growth of y from (t, y) over `duration`, by the closed forms of the singular laws, at the constant
  /// stress that y has at `stress_time`. @throws RecoverableError
  virtual void start_increment(double t, std::span<const double> y, double stress_time, double duration,
                               std::span<double> change) = 0;
};

/// f is a pure function of (t, y): the data that accept() stores may affect the cost of an evaluation, not its value.
/// Calls are collective, from one thread at a time.
class System {
 public:
  virtual ~System() = default;
  /// Size of the part of the state that this process holds; all spans below have this length.
  virtual std::size_t size() const = 0;
  /// The processes that share the state; norms are taken over all of it.
  virtual const Team& team() const { return serial_team(); }

  /// rate = f(t, y). @throws RecoverableError to ask for a smaller step; any other exception ends the run
  virtual void rate(double t, std::span<const double> y, std::span<double> rate) = 0;

  /// Largest step for which explicit Euler is stable at (t, y) (Cormeau 1975); infinity if nothing creeps.
  virtual double stable_step(double t, std::span<const double> y) = 0;

  /// Time up to which the rate is a smooth function of time, however short the steps have to be; infinity: not known.
  virtual double end_of_segment() const { return std::numeric_limits<double>::infinity(); }

  /// Error of y_i that counts as relative error 1: absolute tolerance = tolerance * scale()[i].
  /// May change in accept().
  virtual std::span<const double> scale() const = 0;

  /// Announces that (t, y) is an accepted step; later warm starts are taken from it.
  virtual void accept(double t, std::span<const double> y) = 0;
  /// True if accept() has made the rate at the accepted point another one than evaluations before it gave, by more than
  /// the tolerance. Methods that carry that rate on to the next step evaluate it again.
  virtual bool rate_has_jumped() const { return false; }
  /// Discards evaluations made so far, so that later ones depend to the last bit only on what accept() has stored.
  /// Integrators call it at restart points.
  virtual void forget_evaluations() {}

  // Optional capabilities; null: not offered.
  virtual JacobianProducts* jacobian() { return nullptr; }
  virtual NewtonSolver* newton_solver() { return nullptr; }
  virtual SingularRate* singular_rate() { return nullptr; }

  /// Calls since construction.
  struct Counters {
    std::int64_t rate_evaluations = 0;
    std::int64_t jacobian_products = 0;
  };
  virtual Counters counters() const = 0;
};

}  // namespace creepcontact::ode
