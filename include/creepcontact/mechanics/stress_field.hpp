#pragma once
/// Stress as a function of the place: that of a body before it is loaded.

#include <functional>
#include <memory>
#include <vector>

#include "creepcontact/base/tensor.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mechanics {

/// In Mandel order along the coordinates; as thread-safe as what it calls.
using StressField = std::function<Tensor6(const Vector3& place)>;

/// Stress between points where it is known: every component by moving least squares, exact for linear fields. Value
/// semantics; copies share the points.
class ScatteredStress {
 public:
  /// @param points  at least one, no two the same @param values  one per point, Mandel
  ScatteredStress(const std::vector<Vector3>& points, std::vector<Tensor6> values);
  Tensor6 operator()(const Vector3& place) const;
  /// The distance to the nearest point if the place is so far outside that this one alone counts; else 0.
  double outside(const Vector3& place) const;

 private:
  struct Points;
  std::shared_ptr<const Points> points_;
};

}  // namespace creepcontact::mechanics
