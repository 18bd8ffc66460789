#pragma once
/// Acceleration of a fixed-point iteration x -> g(x).

#include <Eigen/Dense>
#include <algorithm>

#include "creepcontact/contact/contact_solver.hpp"

namespace creepcontact::contact {

/// none: x = g(x). aitken: relaxation by Aitken's delta-squared (Irons and Tuck 1969). anderson: least squares over the
/// last two differences (Anderson 1965); deeper histories hurt.
class FixedPoint {
 public:
  using Acceleration = SchwarzOptions::Acceleration;
  FixedPoint(Acceleration kind, Eigen::Index size) : kind_(kind) {
    if (kind == Acceleration::anderson) {
      residual_steps_.setZero(size, depth);
      image_steps_.setZero(size, depth);
    }
  }

  /// @param x  overwritten by the next iterate; @param image  g(x)
  void advance(Eigen::VectorXd& x, const Eigen::VectorXd& image) {
    const Eigen::VectorXd residual = image - x;
    if (kind_ == Acceleration::aitken)
      aitken(x, residual);
    else if (kind_ == Acceleration::anderson)
      anderson(x, image, residual);
    else
      x = image;
    last_residual_ = residual;
    last_image_ = image;
    ++count_;
  }

 private:
  static constexpr int depth = 2;

  void aitken(Eigen::VectorXd& x, const Eigen::VectorXd& residual) {
    if (count_ > 0) {
      const Eigen::VectorXd step = residual - last_residual_;
      const double square = step.squaredNorm();
      if (square > 0) relaxation_ *= -last_residual_.dot(step) / square;
    }
    x += relaxation_ * residual;
  }

  void anderson(Eigen::VectorXd& x, const Eigen::VectorXd& image, const Eigen::VectorXd& residual) {
    x = image;
    if (count_ == 0) return;
    residual_steps_.col((count_ - 1) % depth) = residual - last_residual_;
    image_steps_.col((count_ - 1) % depth) = image - last_image_;
    const Eigen::Index used = std::min<Eigen::Index>(count_, depth);
    const Eigen::VectorXd mix = residual_steps_.leftCols(used).completeOrthogonalDecomposition().solve(residual);
    x -= image_steps_.leftCols(used) * mix;
  }

  Acceleration kind_;
  double relaxation_ = 1.0;
  int count_ = 0;
  Eigen::VectorXd last_residual_, last_image_;
  Eigen::MatrixXd residual_steps_, image_steps_;
};

}  // namespace creepcontact::contact
