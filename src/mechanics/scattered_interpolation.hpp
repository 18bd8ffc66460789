#pragma once
/// Interpolation of values at scattered points: at every place a linear function fitted to the nearest points, weighted
/// by distance (moving least squares, with the weights of Franke and Nielson 1980, which grow without bound towards a
/// point: there the value is the point's).

#include <memory>
#include <span>
#include <vector>

#include "creepcontact/mesh/mesh.hpp"
#include "creepcontact/mesh/point_tree.hpp"

namespace creepcontact::mechanics {

/// The value at a place: sum of weight x value of the point. The weights sum up to 1.
struct PointWeight {
  std::size_t point;
  double weight;
};

class ScatteredInterpolation {
 public:
  /// Points of a plane, a line or a single one: the values are constant across it.
  /// @param points  at least one, no two the same
  explicit ScatteredInterpolation(std::span<const Vector3> points);
  ~ScatteredInterpolation();
  ScatteredInterpolation(ScatteredInterpolation&&) noexcept;
  ScatteredInterpolation& operator=(ScatteredInterpolation&&) noexcept;

  /// Exact for linear functions inside and near the cloud; far outside it is the nearest point alone.
  /// Safe for any number of threads. Cost: a search in a tree of the points.
  std::vector<PointWeight> weights(const Vector3& position) const;

  /// The nearest point, if a place is so far outside that this point alone gives the value; the distance is measured
  /// within the plane or line of the points. Otherwise the distance is 0.
  mesh::Neighbour outside(const Vector3& position) const;

 private:
  struct Cloud;
  std::unique_ptr<Cloud> cloud_;
};

}  // namespace creepcontact::mechanics
