#include "node_conditions.hpp"

#include <Eigen/Geometry>

namespace creepcontact::mechanics {

namespace {
/// Directions closer than this (as an angle) are the same: above the noise of normals, far below any real inclination.
constexpr double tolerance = 1e-8;
}  // namespace

std::optional<NodeConditions::Dependent> NodeConditions::add(std::size_t label, const Vector3& direction) {
  const auto basis = held_.leftCols(n_held_);
  Vector3 rest = direction - basis * (basis.transpose() * direction);
  rest -= basis * (basis.transpose() * rest);  // once more, so that nearly parallel directions stay orthogonal
  if (n_held_ < 3 && rest.norm() > tolerance) {
    held_.col(n_held_) = rest.normalized();
    directions_.col(n_held_) = direction;
    labels_.push_back(label);
    ++n_held_;
    return std::nullopt;
  }
  const Eigen::VectorXd coefficients = displacements().transpose() * direction;
  Dependent dependent;
  for (int i = 0; i < n_held_; ++i) {
    if (std::abs(coefficients[i]) <= tolerance) continue;
    dependent.on.push_back(labels_[i]);
    dependent.coefficients.push_back(coefficients[i]);
  }
  return dependent;
}

Eigen::Matrix3Xd NodeConditions::displacements() const {
  // u = Q y with D^T Q y = g; D^T Q is lower triangular by construction of Q.
  const auto basis = held_.leftCols(n_held_);
  const Eigen::MatrixXd triangle = directions_.leftCols(n_held_).transpose() * basis;
  return basis * triangle.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd::Identity(n_held_, n_held_));
}

Matrix3 NodeConditions::frame() const {
  const Matrix3 projector = held_.leftCols(n_held_) * held_.leftCols(n_held_).transpose();
  std::vector<int> held_axes, free_axes;
  for (int i = 0; i < 3; ++i) {
    if ((projector.col(i) - Vector3::Unit(i)).norm() < tolerance) held_axes.push_back(i);
    if (projector.col(i).norm() < tolerance) free_axes.push_back(i);
  }
  Matrix3 frame;
  if (held_axes.size() + free_axes.size() == 3) {
    held_axes.insert(held_axes.end(), free_axes.begin(), free_axes.end());
    for (int i = 0; i < 3; ++i) frame.col(i) = Vector3::Unit(held_axes[i]);
    return frame;
  }
  frame.leftCols(n_held_) = held_.leftCols(n_held_);
  if (n_held_ == 1) frame.col(1) = free_axes.empty() ? frame.col(0).unitOrthogonal() : Vector3::Unit(free_axes[0]);
  frame.col(2) = frame.col(0).cross(frame.col(1));
  return frame;
}

}  // namespace creepcontact::mechanics
