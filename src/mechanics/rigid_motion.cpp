#include "creepcontact/mechanics/rigid_motion.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/dense.hpp"

namespace creepcontact::mechanics {

namespace {

/// Tolerance for unit directions and motions; rotations are measured by the displacement at the body's outer reach.
constexpr double rank_tolerance = 1e-9;

Vector3 readable(Vector3 v) {
  Index largest = 0;
  v.cwiseAbs().maxCoeff(&largest);
  if (v[largest] < 0) v = -v;
  return (v.array().abs() < 1e-12).select(0.0, v);
}

/// Basis of the space spanned by some columns: first the coordinate directions in it, then what is left.
std::vector<Vector3> readable_basis(const Eigen::Matrix3Xd& columns) {
  if (columns.cols() == 0) return {};
  const linalg::SingularValues svd = linalg::singular_values(columns);
  const Index rank = (svd.values.array() > rank_tolerance).count();
  const Eigen::Matrix3Xd space = svd.left.leftCols(rank);
  std::vector<Vector3> basis;
  const auto without_basis = [&](Vector3 v) {
    v = (space * (space.transpose() * v)).eval();
    for (const Vector3& b : basis) v -= b * b.dot(v);
    return v;
  };
  for (int i = 0; i < 3; ++i) {
    if ((space * (space.transpose() * Vector3::Unit(i)) - Vector3::Unit(i)).norm() < 1e-8)
      basis.emplace_back(Vector3::Unit(i));
  }
  while (static_cast<Index>(basis.size()) < rank) {
    Vector3 best = Vector3::Zero();
    for (int i = 0; i < 3; ++i) {
      const Vector3 rest = without_basis(Vector3::Unit(i));
      if (rest.norm() > best.norm() * (1 + 1e-8)) best = rest;
    }
    basis.push_back(readable(best.normalized()));
  }
  return basis;
}

Eigen::Matrix3Xd as_columns(const std::vector<Vector3>& vectors) {
  Eigen::Matrix3Xd columns(3, vectors.size());
  for (std::size_t i = 0; i < vectors.size(); ++i) columns.col(i) = vectors[i];
  return columns;
}

std::string along(const Vector3& direction) {
  for (int i = 0; i < 3; ++i)
    if ((direction.cwiseAbs() - Vector3::Unit(i)).norm() < 1e-8) return std::string(1, "xyz"[i]);
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", direction[0], direction[1], direction[2]);
}

}  // namespace

Eigen::MatrixXd rigid_motions_on_free(const std::vector<Vector3>& nodes, const Constraints& constraints) {
  Vector3 centre = Vector3::Zero();
  for (const Vector3& node : nodes) centre += node / static_cast<double>(nodes.size());
  const std::vector<double> no_displacement(constraints.n_full(), 0.0);
  Eigen::VectorXd full(constraints.n_full()), free(constraints.n_free());
  const std::size_t n_free = constraints.n_free();
  const auto restricted = [&] {
    constraints.restrict_to_free({full.data(), no_displacement.size()}, {free.data(), n_free});
    return free;
  };
  Eigen::MatrixXd result(constraints.n_free(), 6);
  for (int k = 0; k < 6; ++k) {
    RigidMotion motion{.centre = centre};
    (k < 3 ? motion.translation : motion.rotation)[k % 3] = 1;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      full.segment<3>(3 * static_cast<Index>(i)) = motion.displacement(nodes[i]);
    // T^T T x = T^T full by conjugate gradients: without links T^T T is the identity.
    constexpr int most_iterations = 30;
    constexpr double accurate = 1e-10;
    Eigen::VectorXd x = Eigen::VectorXd::Zero(free.size()), residual = restricted(), direction = residual;
    double square = residual.squaredNorm();
    const double end = accurate * accurate * square;
    for (int iteration = 0; iteration < most_iterations && square > end; ++iteration) {
      constraints.expand({direction.data(), n_free}, no_displacement, {full.data(), no_displacement.size()});
      const Eigen::VectorXd product = restricted();
      const double step = square / direction.dot(product);
      x += step * direction;
      residual -= step * product;
      const double next = residual.squaredNorm();
      direction = residual + next / square * direction;
      square = next;
    }
    result.col(k) = x;
  }
  return result;
}

std::vector<Vector3> resisted_directions(const mesh::Mesh& mesh, const Constraints& constraints, std::int64_t node) {
  std::vector<Vector3> directions;
  directions.reserve(4);
  const Matrix3 frame = constraints.frame(node);
  for (int k = 0; k < constraints.n_held(node); ++k) directions.emplace_back(frame.col(k));
  if (mesh.section.is_axisymmetric()) directions.emplace_back(Vector3::UnitX());
  return directions;
}

std::vector<RigidMotion> free_rigid_motions(const mesh::Mesh& mesh, const Constraints& constraints,
                                            const std::vector<std::int64_t>& subset) {
  const auto position = [&](std::int64_t node) { return mesh.nodes[node]; };
  Vector3 centre = Vector3::Zero();
  for (const std::int64_t node : subset) centre += position(node) / static_cast<double>(subset.size());
  double size = 0;
  for (const std::int64_t node : subset) size = std::max(size, (position(node) - centre).norm());

  // q . (t + w x r) = 0 for every held direction q; unknowns t and size * w.
  std::vector<Eigen::Matrix<double, 6, 1>> held;
  for (const std::int64_t node : subset) {
    for (const Vector3& q : resisted_directions(mesh, constraints, node)) {
      held.emplace_back();
      held.back() << q, (position(node) - centre).cross(q) / size;
    }
  }
  const auto linked = constraints.conditions_on_motions(mesh.nodes, centre, size);
  Eigen::MatrixXd rows(std::ssize(held) + linked.rows(), 6);
  for (std::size_t i = 0; i < held.size(); ++i) rows.row(i) = held[i].transpose();
  rows.bottomRows(linked.rows()) = linked;
  const Eigen::MatrixXd free = linalg::null_space(rows, rank_tolerance);
  if (free.cols() == 0) return {};

  std::vector<RigidMotion> motions;
  motions.reserve(6);
  // Pure translations: the combinations of the modes that do not rotate.
  const std::vector<Vector3> translations =
      readable_basis(free.topRows<3>() * linalg::null_space(free.bottomRows<3>(), rank_tolerance));
  for (const Vector3& direction : translations) motions.push_back({direction, Vector3::Zero(), centre});
  // Rotations are determined up to those translations.
  const Eigen::Matrix3Xd t = as_columns(translations);
  for (const Vector3& axis : readable_basis(free.bottomRows<3>())) {
    const Eigen::VectorXd combination = linalg::least_squares(free.bottomRows<3>(), axis, rank_tolerance);
    Vector3 shift = size * (free.topRows<3>() * combination);
    shift -= t * (t.transpose() * shift);
    RigidMotion motion{axis * axis.dot(shift), axis, centre + axis.cross(shift)};
    if (motion.translation.norm() < 1e-8 * size) motion.translation.setZero();
    motion.centre = (motion.centre.array().abs() < 1e-9 * size).select(0.0, motion.centre);
    motions.push_back(motion);
  }
  return motions;
}

RigidMotion RigidMotion::combination(const std::vector<RigidMotion>& motions, const Eigen::VectorXd& amplitudes) {
  RigidMotion sum;
  if (motions.empty()) return sum;
  sum.centre = motions.front().centre;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    sum.translation += amplitudes[i] * motions[i].displacement(sum.centre);
    sum.rotation += amplitudes[i] * motions[i].rotation;
  }
  return sum;
}

Vector3 RigidMotion::displacement(const Vector3& x) const {
  return translation + rotation.cross(x - centre);
}

RigidMotion RigidMotion::tidied(double size) const {
  constexpr double min_part = 1e-4;
  const auto without_small = [](const Vector3& v, double limit) {
    return Vector3((v.array().abs() < limit).select(0.0, v));
  };
  const double angle = rotation.norm();
  if (angle * size < min_part * translation.norm())
    return {readable(without_small(translation, min_part * translation.norm())), Vector3::Zero(), centre};
  const Vector3 axis = readable(without_small(rotation / angle, min_part).normalized());
  const Vector3 through = without_small(centre + axis.cross(translation) / axis.dot(rotation), min_part * size);
  const double pitch = axis.dot(translation) / axis.dot(rotation);
  return {std::abs(pitch) < min_part * size ? Vector3(Vector3::Zero()) : Vector3(pitch * angle * axis), angle * axis,
          through};
}

std::string RigidMotion::describe() const {
  const double angle = rotation.norm();
  if (angle == 0) return "translation along " + along(translation.normalized());
  // The motion turns about the line on which the displacement is parallel to the axis.
  const Vector3 axis = rotation / angle;
  const Vector3 through = centre + axis.cross(translation) / angle;
  std::string text = fmt::format("rotation about the axis ({:.4g}, {:.4g}, {:.4g}) through ({:.6g}, {:.6g}, {:.6g})",
                                 axis[0], axis[1], axis[2], through[0], through[1], through[2]);
  const double pitch = axis.dot(translation) / angle;
  if (pitch != 0) text += fmt::format(" with a shift of {:.4g} along it per radian", pitch);
  return text;
}

}  // namespace creepcontact::mechanics
