#pragma once
/// A stiff differential equation of few unknowns, step by step: Rosenbrock's method with the coefficients RODAS of
/// order 4 (E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 1996, section IV.10), L-stable, with
/// error estimate and interpolation. No iteration that could fail to converge.

#include <Eigen/Core>
#include <array>

namespace creepcontact::material {

/// dy/dt = f(t, y)
class StiffSystem {
 public:
  virtual ~StiffSystem() = default;
  virtual Eigen::VectorXd rate(double t, const Eigen::VectorXd& y) const = 0;
  virtual Eigen::MatrixXd jacobian(double t, const Eigen::VectorXd& y) const = 0;  ///< exact df/dy
};

/// One step, and the solution within it.
class RosenbrockStep {
 public:
  /// The step from (t, y) over h. Precondition: t > 0, h > 0. Cost: one Jacobian, eight rates, one dense factor.
  RosenbrockStep(const StiffSystem& system, double t, double h, const Eigen::VectorXd& y);

  bool is_finite() const { return end_.allFinite() && error_.allFinite(); }
  const Eigen::VectorXd& end() const { return end_; }
  const Eigen::VectorXd& error() const { return error_; }  ///< estimated, of order h^4
  /// The solution at t + part h, order 3. @param part  in [0, 1]
  Eigen::VectorXd within(double part) const;

 private:
  Eigen::VectorXd begin_, end_, error_, third_, fourth_;  // of the interpolation
};

}  // namespace creepcontact::material
