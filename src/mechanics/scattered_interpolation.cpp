#include "creepcontact/mechanics/scattered_interpolation.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <iterator>
#include <utility>

namespace creepcontact::mechanics {
namespace {

using BoostPoint = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
using Entry = std::pair<BoostPoint, std::size_t>;
using Tree = boost::geometry::index::rtree<Entry, boost::geometry::index::rstar<16>>;

constexpr double flat = 1e-6;        // extent of a cloud over its largest one, below which it has none
constexpr double poor = 1e-3;        // share of a direction in the weighted extent of the neighbours: too little
constexpr double few = 0.02;         // the same, unweighted: more neighbours are looked for
constexpr double coincident = 1e-9;  // of the distance of the neighbours
constexpr double reach = 1.25;       // radius at which weights vanish, over the distance of the last neighbour
constexpr double one_sided = 0.8;    // mean of the directions towards the neighbours, seen from outside
constexpr double far_off = 0.7;      // distance of the nearest point over the extent of the neighbours, the same
constexpr std::size_t most = 400;    // neighbours that are looked at

BoostPoint boost_point(const Vector3& x) {
  return {x[0], x[1], x[2]};
}

struct Neighbours {
  std::vector<std::size_t> points;  // the nearest first
  std::vector<double> distances;
};

}  // namespace

/// In coordinates along the directions in which the points extend; the others are 0.
struct ScatteredInterpolation::Cloud {
  explicit Cloud(std::span<const Vector3> given) {
    for (const Vector3& x : given) center_ += x;
    center_ /= static_cast<double>(given.size());
    Matrix3 moments = Matrix3::Zero();
    for (const Vector3& x : given) moments += (x - center_) * (x - center_).transpose();
    const tensor::Principal principal(moments);
    const Eigen::Vector3d extent = principal.values.cwiseMax(0).cwiseSqrt();
    for (int k = 2; k >= 0 && extent[k] > flat * extent[2]; --k) axes_.row(dimension++) = principal.directions.col(k);

    std::vector<Entry> entries;
    for (const Vector3& x : given) {
      points.push_back(local(x));
      entries.emplace_back(boost_point(points.back()), entries.size());
    }
    tree_ = Tree(entries);
  }

  Vector3 local(const Vector3& place) const { return axes_ * (place - center_); }

  /// So many that they lie in all directions of the cloud as seen from the place, if that many are there.
  Neighbours neighbours(const Vector3& x) const {
    constexpr std::size_t first[]{1, 4, 10, 16};
    for (std::size_t n = first[dimension];; n *= 2) {
      n = std::min(n, std::min(most, points.size()));
      Neighbours found = nearest(x, n);
      if (covered(found) || n == std::min(most, points.size())) return found;
    }
  }

  /// Nothing but the nearest point is near enough to be extrapolated from.
  bool is_outside(const Vector3& x, const Neighbours& around) const {
    if (dimension == 0) return false;
    Vector3 mean = Vector3::Zero();
    double extent = 0;
    for (std::size_t i = 0; i < around.points.size(); ++i) {
      mean += (points[around.points[i]] - x) / around.distances[i];
      extent = std::max(extent, (points[around.points[i]] - points[around.points[0]]).norm());
    }
    return mean.norm() > one_sided * static_cast<double>(around.points.size()) &&
           around.distances[0] > far_off * extent;
  }

  int dimension = 0;
  std::vector<Vector3> points;

 private:
  Neighbours nearest(const Vector3& x, std::size_t n) const {
    std::vector<Entry> entries;
    tree_.query(boost::geometry::index::nearest(boost_point(x), static_cast<unsigned>(n)), std::back_inserter(entries));
    std::vector<std::pair<double, std::size_t>> sorted;
    for (const Entry& entry : entries) sorted.emplace_back((points[entry.second] - x).norm(), entry.second);
    std::sort(sorted.begin(), sorted.end());
    Neighbours found;
    for (const auto& [distance, point] : sorted) {
      found.points.push_back(point);
      found.distances.push_back(distance);
    }
    return found;
  }

  /// Directions from the nearest point to the others.
  bool covered(const Neighbours& around) const {
    if (dimension == 0 || around.distances[0] <= coincident * around.distances.back()) return true;
    Matrix3 directions = Matrix3::Zero();
    for (std::size_t i = 1; i < around.points.size(); ++i) {
      const Vector3 d = (points[around.points[i]] - points[around.points[0]]).normalized();
      directions += d * d.transpose();
    }
    const Vector3 shares = tensor::principal_values(directions);
    return shares[3 - dimension] > few * shares[2];
  }

  Vector3 center_ = Vector3::Zero();
  Matrix3 axes_ = Matrix3::Zero();
  Tree tree_;
};

ScatteredInterpolation::ScatteredInterpolation(std::span<const Vector3> points)
    : cloud_(std::make_unique<Cloud>(points)) {}
ScatteredInterpolation::~ScatteredInterpolation() = default;
ScatteredInterpolation::ScatteredInterpolation(ScatteredInterpolation&&) noexcept = default;
ScatteredInterpolation& ScatteredInterpolation::operator=(ScatteredInterpolation&&) noexcept = default;

std::vector<PointWeight> ScatteredInterpolation::weights(const Vector3& place) const {
  const Vector3 x = cloud_->local(place);
  const Neighbours around = cloud_->neighbours(x);
  const std::size_t n = around.points.size();
  const double radius = reach * around.distances.back();
  if (n == 1 || around.distances[0] <= coincident * radius || cloud_->is_outside(x, around))
    return {{around.points[0], 1.0}};

  // Fitted about the weighted mean of the points: value(x) = mean value + slope (x - mean point).
  Eigen::VectorXd w(n);
  Eigen::Matrix3Xd away(3, n);
  for (std::size_t i = 0; i < n; ++i) {
    const double r = around.distances[i];
    w[static_cast<Eigen::Index>(i)] = std::pow((radius - r) / (radius * r), 2);
    away.col(static_cast<Eigen::Index>(i)) = cloud_->points[around.points[i]] - x;
  }
  w /= w.sum();
  const Vector3 mean = away * w;
  away.colwise() -= mean;
  const Matrix3 moments = away * w.asDiagonal() * away.transpose();
  const tensor::Principal principal(moments);
  Vector3 inverse = Vector3::Zero();  // none across directions that the points hardly have: constant there
  for (int k = 3 - cloud_->dimension; k < 3; ++k)
    if (principal.values[k] > poor * principal.values[2]) inverse[k] = 1 / principal.values[k];
  const Matrix3& axes = principal.directions;
  const Vector3 slope = -(axes * inverse.asDiagonal() * axes.transpose() * mean);

  std::vector<PointWeight> result;
  for (std::size_t i = 0; i < n; ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    result.push_back({around.points[i], w[column] * (1 + slope.dot(away.col(column)))});
  }
  return result;
}

double ScatteredInterpolation::distance_outside(const Vector3& place) const {
  const Vector3 x = cloud_->local(place);
  const Neighbours around = cloud_->neighbours(x);
  return cloud_->is_outside(x, around) ? around.distances[0] : 0.0;
}

}  // namespace creepcontact::mechanics
