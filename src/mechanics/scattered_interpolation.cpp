#include "scattered_interpolation.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "creepcontact/mesh/point_tree.hpp"

namespace creepcontact::mechanics {
namespace {

using Neighbours = std::vector<mesh::Neighbour>;  // the nearest first

constexpr double min_extent = 1e-6;  // extent of a cloud over its largest one, below which it has none
constexpr double min_weighted_share =
    1e-3;                                   // share of a direction in the weighted extent of the neighbours: too little
constexpr double min_share = 0.02;          // the same, unweighted: more neighbours are looked for
constexpr double coincident = 1e-9;         // of the distance of the neighbours
constexpr double weight_radius = 1.25;      // radius at which weights vanish, over the distance of the last neighbour
constexpr double min_mean_direction = 0.8;  // mean of the directions towards the neighbours, seen from outside
constexpr double min_distance_outside =
    0.7;                           // distance of the nearest point over the extent of the neighbours, the same
constexpr std::size_t most = 400;  // neighbours that are looked at

}  // namespace

/// The points in coordinates along the directions in which the points extend; the others are 0.
struct ScatteredInterpolation::Cloud {
  explicit Cloud(std::span<const Vector3> given) {
    for (const Vector3& x : given) center_ += x;
    center_ /= static_cast<double>(given.size());
    Matrix3 moments = Matrix3::Zero();
    for (const Vector3& x : given) moments += (x - center_) * (x - center_).transpose();
    const tensor::Principal principal(moments);
    const Eigen::Vector3d extent = principal.values.cwiseMax(0).cwiseSqrt();
    for (int k = 2; k >= 0 && extent[k] > min_extent * extent[2]; --k)
      axes_.row(dimension++) = principal.directions.col(k);
    for (const Vector3& x : given) points.push_back(local(x));
    tree_.emplace(points);
  }

  Vector3 local(const Vector3& position) const { return axes_ * (position - center_); }

  /// So many that they lie in all directions of the cloud as seen from the place, if that many are there.
  Neighbours neighbours(const Vector3& x) const {
    constexpr std::size_t first[]{1, 4, 10, 16};
    for (std::size_t n = first[dimension];; n *= 2) {
      n = std::min(n, std::min(most, points.size()));
      Neighbours found = tree_->nearest(x, n);
      if (covered(found) || n == std::min(most, points.size())) return found;
    }
  }

  /// Nothing but the nearest point is near enough to be extrapolated from.
  bool is_outside(const Vector3& x, const Neighbours& around) const {
    if (dimension == 0) return false;
    Vector3 mean = Vector3::Zero();
    double extent = 0;
    for (const auto& [point, distance] : around) {
      mean += (points[point] - x) / distance;
      extent = std::max(extent, (points[point] - points[around.front().point]).norm());
    }
    return mean.norm() > min_mean_direction * static_cast<double>(around.size()) &&
           around.front().distance > min_distance_outside * extent;
  }

  int dimension = 0;
  std::vector<Vector3> points;

 private:
  /// Directions from the nearest point to the others.
  bool covered(const Neighbours& around) const {
    if (dimension == 0 || around.front().distance <= coincident * around.back().distance) return true;
    Matrix3 directions = Matrix3::Zero();
    for (std::size_t i = 1; i < around.size(); ++i) {
      const Vector3 d = (points[around[i].point] - points[around.front().point]).normalized();
      directions += d * d.transpose();
    }
    const Vector3 shares = tensor::principal_values(directions);
    return shares[3 - dimension] > min_share * shares[2];
  }

  Vector3 center_ = Vector3::Zero();
  Matrix3 axes_ = Matrix3::Zero();
  std::optional<mesh::PointTree> tree_;
};

ScatteredInterpolation::ScatteredInterpolation(std::span<const Vector3> points)
    : cloud_(std::make_unique<Cloud>(points)) {}
ScatteredInterpolation::~ScatteredInterpolation() = default;
ScatteredInterpolation::ScatteredInterpolation(ScatteredInterpolation&&) noexcept = default;
ScatteredInterpolation& ScatteredInterpolation::operator=(ScatteredInterpolation&&) noexcept = default;

std::vector<PointWeight> ScatteredInterpolation::weights(const Vector3& position) const {
  const Vector3 x = cloud_->local(position);
  const Neighbours around = cloud_->neighbours(x);
  const std::size_t n = around.size();
  const double radius = weight_radius * around.back().distance;
  if (n == 1 || around.front().distance <= coincident * radius || cloud_->is_outside(x, around))
    return {{around.front().point, 1.0}};

  // Fitted about the weighted mean of the points: value(x) = mean value + slope (x - mean point).
  Eigen::VectorXd w(n);
  Eigen::Matrix3Xd away(3, n);
  for (std::size_t i = 0; i < n; ++i) {
    const double r = around[i].distance;
    w[i] = std::pow((radius - r) / (radius * r), 2);
    away.col(i) = cloud_->points[around[i].point] - x;
  }
  w /= w.sum();
  const Vector3 mean = away * w;
  away.colwise() -= mean;
  const Matrix3 moments = away * w.asDiagonal() * away.transpose();
  const tensor::Principal principal(moments);
  Vector3 inverse = Vector3::Zero();  // none across directions that the points hardly have: constant there
  for (int k = 3 - cloud_->dimension; k < 3; ++k)
    if (principal.values[k] > min_weighted_share * principal.values[2]) inverse[k] = 1 / principal.values[k];
  const Matrix3& axes = principal.directions;
  const Vector3 slope = -(axes * inverse.asDiagonal() * axes.transpose() * mean);

  std::vector<PointWeight> result;
  for (std::size_t i = 0; i < n; ++i) result.push_back({around[i].point, w[i] * (1 + slope.dot(away.col(i)))});
  return result;
}

mesh::Neighbour ScatteredInterpolation::outside(const Vector3& position) const {
  const Vector3 x = cloud_->local(position);
  const Neighbours around = cloud_->neighbours(x);
  return cloud_->is_outside(x, around) ? around.front() : mesh::Neighbour{};
}

}  // namespace creepcontact::mechanics
