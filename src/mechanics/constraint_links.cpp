/// Links between the nodes of a body: cyclic symmetry and rigid surfaces.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/dense.hpp"
#include "creepcontact/mechanics/constraints.hpp"

namespace creepcontact::mechanics {
namespace {

using Row6 = Eigen::Matrix<double, 1, 6>;
using Motion = Eigen::Matrix<double, 3, 6>;

constexpr double rank_tolerance = 1e-9;
constexpr double same_value = 1e-8;

/// Displacement at `arm` from the centre by (d, size w).
Motion motion_at(const Vector3& arm, double size) {
  Motion motion;
  motion.leftCols<3>().setIdentity();
  for (int k = 0; k < 3; ++k) motion.col(3 + k) = Vector3::Unit(k).cross(arm) / size;
  return motion;
}

double largest_arm(const std::vector<Vector3>& arms) {
  double size = 0;
  for (const Vector3& arm : arms) size = std::max(size, arm.norm());
  return size > 0 ? size : 1;
}

}  // namespace

const NodeLinks::Turned* Constraints::turned_or_null(std::int64_t node) const {
  return turned_.empty() || turned_[node] < 0 ? nullptr : &links_.turned[turned_[node]];
}

const Constraints::RigidSurface* Constraints::surface_or_null(std::int64_t node) const {
  return surface_.empty() || surface_[node] < 0 ? nullptr : &surfaces_[surface_[node]];
}

void Constraints::find_linked_nodes(const std::vector<Vector3>& nodes) {
  if (links_.empty()) return;
  turned_.assign(nodes.size(), -1);
  surface_.assign(nodes.size(), -1);
  for (const NodeLinks::Rigid& rigid : links_.rigid) {
    RigidSurface surface;
    surface.centre = rigid.origin;
    surface.nodes = rigid.nodes;
    std::ranges::sort(surface.nodes);
    for (const std::int64_t node : surface.nodes) {
      if (surface_[node] >= 0)
        throw ModelError(fmt::format("the rigid surfaces '{}' and '{}' have nodes in common; make one group of them",
                                     links_.rigid[surface_[node]].on, rigid.on));
      surface_[node] = std::ssize(surfaces_);
      surface.arms.emplace_back(nodes[node] - surface.centre);
    }
    for (int k = 0; k < 3; ++k) {
      Eigen::Matrix<double, 6, 1> row = Eigen::Matrix<double, 6, 1>::Zero();
      row[k] = 1;
      if (rigid.displacement[k]) surface.conditions.push_back({row, *rigid.displacement[k], surface.centre});
      row[k] = 0;
      row[3 + k] = 1;
      if (rigid.rotation[k]) surface.conditions.push_back({row, *rigid.rotation[k], surface.centre});
    }
    surfaces_.push_back(std::move(surface));
  }
  for (std::size_t i = 0; i < links_.turned.size(); ++i) {
    const NodeLinks::Turned& turned = links_.turned[i];
    if (turned.node == turned.of) continue;  // held to the axis
    const RigidSurface* surface = surface_or_null(turned.node);
    if (surface != surface_or_null(turned.of))
      throw ModelError(fmt::format(
          "the rigid surface '{}' ends at a face of cyclic symmetry without a node that it is linked to; let "
          "it reach from one face to the other",
          links_.rigid[std::max(surface_[turned.node], surface_[turned.of])].on));
    if (surface == nullptr) {
      turned_[turned.node] = static_cast<std::int64_t>(i);
      continue;
    }
    // The motion of the surface must be symmetric itself.
    RigidSurface& own = surfaces_[surface_[turned.node]];
    const Motion difference =
        motion_at(nodes[turned.node] - own.centre, 1) - turned.rotation * motion_at(nodes[turned.of] - own.centre, 1);
    for (int k = 0; k < 3; ++k) own.conditions.push_back({difference.row(k).transpose(), 0.0, nodes[turned.node]});
  }
}

void Constraints::hold_rigid_surfaces(const std::vector<Vector3>& nodes, const std::vector<Support>& supports) {
  for (const Support& support : supports)
    for (std::size_t i = 0; i < support.nodes.size(); ++i) {
      const std::int64_t node = support.nodes[i];
      if (surface_or_null(node) == nullptr) continue;
      RigidSurface& surface = surfaces_[surface_[node]];
      const Vector3 direction = support.directions[support.directions.size() == 1 ? 0 : i].normalized();
      surface.conditions.push_back(
          {motion_at(nodes[node] - surface.centre, 1).transpose() * direction, support.value, nodes[node]});
    }
  for (std::size_t s = 0; s < surfaces_.size(); ++s) {
    RigidSurface& surface = surfaces_[s];
    const double size = largest_arm(surface.arms);
    const Eigen::Matrix<double, 6, 1> scale{1, 1, 1, 1 / size, 1 / size, 1 / size};  // (d, w) of (d, size w)
    Eigen::MatrixXd rows(surface.conditions.size(), 6);
    for (std::size_t i = 0; i < surface.conditions.size(); ++i)
      rows.row(static_cast<Index>(i)) = surface.conditions[i].row.cwiseProduct(scale).transpose();
    // Nodes on a line leave the rotation about it without effect.
    Eigen::MatrixXd effects(3 * std::ssize(surface.arms), 6);
    for (std::size_t i = 0; i < surface.arms.size(); ++i)
      effects.middleRows<3>(3 * static_cast<Index>(i)) = motion_at(surface.arms[i], size);
    const Eigen::MatrixXd idle = linalg::null_space(effects, rank_tolerance);
    Eigen::MatrixXd all(rows.rows() + idle.cols(), 6);
    all << rows, idle.transpose();
    surface.free = scale.asDiagonal() * linalg::null_space(all, rank_tolerance);
    const Eigen::MatrixXd inverse = linalg::least_squares(all, Eigen::MatrixXd::Identity(all.rows(), all.rows()));
    surface.prescribing = scale.asDiagonal() * inverse.leftCols(rows.rows());
    for (const double t : {0.0, 1.0}) {
      Eigen::VectorXd values(rows.rows());
      for (Index i = 0; i < values.size(); ++i) {
        const auto& [row, value, x] = surface.conditions[static_cast<std::size_t>(i)];
        values[i] = value({.x = x[0], .y = x[1], .z = x[2], .t = t});
      }
      const double error =
          values.size() > 0 ? (rows * (inverse.leftCols(rows.rows()) * values) - values).cwiseAbs().maxCoeff() : 0.0;
      if (error > same_value * (values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0.0))
        throw ModelError(fmt::format(
            "the rigid surface '{}' cannot follow all that is prescribed for it at t = {:g} (by {:.3g}): its "
            "own motion, the supports of its nodes and cyclic symmetry contradict each other; remove some of them",
            links_.rigid[s].on, t, error));
    }
  }
}

void Constraints::make_transformation(const std::vector<Vector3>& nodes) {
  using Triplet = Eigen::Triplet<double, std::int64_t>;
  std::vector<Triplet> entries;
  const auto add = [&](std::int64_t node, std::int64_t column, const Vector3& displacement) {
    for (int k = 0; k < 3; ++k)
      if (displacement[k] != 0) entries.emplace_back(3 * node + k, column, displacement[k]);
  };
  for (std::int64_t node = 0; node < std::ssize(nodes); ++node) {
    const NodeLinks::Turned* turned = turned_or_null(node);
    const std::int64_t of = turned != nullptr ? turned->of : node;
    if (const RigidSurface* surface = surface_or_null(of)) {
      const Motion motion = motion_at(nodes[of] - surface->centre, 1);
      for (Index k = 0; k < surface->free.cols(); ++k)
        add(node, surface->first_free + k, motion * surface->free.col(k));
      continue;
    }
    const Matrix3 axes = frame(node);  // of a linked node turned with it
    for (int k = n_held(of); k < 3; ++k) add(node, free_index_[of][k], axes.col(k));
  }
  transformation_.resize(3 * std::ssize(nodes), n_free());
  transformation_.setFromTriplets(entries.begin(), entries.end());
}

bool Constraints::prescribed_at_links(double t, std::span<double> full) const {
  bool nonzero = false;
  const auto at = [&](std::int64_t node) { return Eigen::Map<Vector3>(full.data() + 3 * node); };
  for (const RigidSurface& surface : surfaces_) {
    Eigen::VectorXd values(surface.conditions.size());
    for (Index i = 0; i < values.size(); ++i) {
      const auto& [row, value, x] = surface.conditions[static_cast<std::size_t>(i)];
      values[i] = value.is_zero() ? 0.0 : value({.x = x[0], .y = x[1], .z = x[2], .t = t});
    }
    if (values.isZero(0)) continue;
    nonzero = true;
    const Eigen::Matrix<double, 6, 1> motion = surface.prescribing * values;
    for (std::size_t i = 0; i < surface.nodes.size(); ++i)
      at(surface.nodes[i]) = motion_at(surface.arms[i], 1) * motion;
  }
  for (std::size_t i = 0; i < links_.turned.size(); ++i) {
    const NodeLinks::Turned& turned = links_.turned[i];
    if (turned_[turned.node] == static_cast<std::int64_t>(i)) at(turned.node) = turned.rotation * at(turned.of);
  }
  return nonzero;
}

Eigen::Matrix<double, Eigen::Dynamic, 6> Constraints::conditions_on_motions(const std::vector<Vector3>& nodes,
                                                                            const Vector3& centre, double size) const {
  std::vector<Row6> rows;
  for (const NodeLinks::Turned& turned : links_.turned) {
    const Motion difference =
        motion_at(nodes[turned.node] - centre, size) - turned.rotation * motion_at(nodes[turned.of] - centre, size);
    for (int k = 0; k < 3; ++k) rows.emplace_back(difference.row(k));
  }
  for (const RigidSurface& surface : surfaces_)
    for (const RigidSurface::Condition& condition : surface.conditions) {
      Eigen::Matrix<double, 6, 6> motion = Eigen::Matrix<double, 6, 6>::Zero();  // (d, w) by (t, size w)
      motion.topRows<3>() = motion_at(surface.centre - centre, size);
      motion.bottomRightCorner<3, 3>().diagonal().setConstant(1 / size);
      rows.emplace_back(condition.row.transpose() * motion);
    }
  Eigen::Matrix<double, Eigen::Dynamic, 6> result(rows.size(), 6);
  for (std::size_t i = 0; i < rows.size(); ++i) result.row(static_cast<Index>(i)) = rows[i];
  return result;
}

linalg::SparseMatrix Constraints::reduce_linked(const linalg::SparseMatrix& lower) const {
  linalg::SparseMatrix full(lower.rows(), lower.cols());
  full = lower.selfadjointView<Eigen::Lower>();
  const linalg::SparseMatrix product = full * transformation_;
  const linalg::SparseMatrix reduced = linalg::SparseMatrix(transformation_.transpose()) * product;
  return reduced.triangularView<Eigen::Lower>();
}

}  // namespace creepcontact::mechanics
