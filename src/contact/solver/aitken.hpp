#pragma once
/// Relaxation of a fixed-point iteration x = g(x) by Aitken's delta-squared. Source: Irons and Tuck (1969).

#include <Eigen/Core>

namespace creepcontact::contact {

class Aitken {
 public:
  /// @param x  overwritten by the next iterate; @param image  g(x)
  void advance(Eigen::VectorXd& x, const Eigen::VectorXd& image) {
    const Eigen::VectorXd residual = image - x;
    if (last_residual_.size() > 0) {
      const Eigen::VectorXd step = residual - last_residual_;
      if (const double square = step.squaredNorm(); square > 0) relaxation_ *= -last_residual_.dot(step) / square;
    }
    x += relaxation_ * residual;
    last_residual_ = residual;
  }

 private:
  double relaxation_ = 1.0;
  Eigen::VectorXd last_residual_;
};

}  // namespace creepcontact::contact
