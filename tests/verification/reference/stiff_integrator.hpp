#pragma once
/// Integration of a small stiff system y' = f(y) to high accuracy: the linearly implicit Euler method, extrapolated.
/// Source: Hairer & Wanner, Solving Ordinary Differential Equations II, section IV.9 (Deuflhard's SEULEX).

#include <Eigen/Core>
#include <functional>

namespace creepcontact::reference {

class StiffIntegrator {
 public:
  using Rate = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;
  using Jacobian = std::function<Eigen::MatrixXd(const Eigen::VectorXd&)>;

  /// @param tolerance  of the local error, relative to the largest entry of y: scale the unknowns alike
  StiffIntegrator(Rate rate, Jacobian jacobian, Eigen::VectorXd y, double tolerance);

  double time() const { return time_; }
  int steps() const { return steps_; }
  const Eigen::VectorXd& state() const { return y_; }

  /// Integrates to exactly `end`. @throws std::runtime_error if the step vanishes
  const Eigen::VectorXd& advance(double end);

 private:
  static constexpr int columns = 7;
  struct Trial {
    Eigen::VectorXd state;
    double error;  ///< in units of the tolerance
  };

  Trial extrapolate(double h) const;

  Rate rate_;
  Jacobian jacobian_;
  Eigen::VectorXd y_;
  double tolerance_, step_ = 0, time_ = 0;
  int steps_ = 0;
};

}  // namespace creepcontact::reference
