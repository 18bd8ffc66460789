#include "creepcontact/mechanics/stress_field.hpp"

#include "scattered_interpolation.hpp"

namespace creepcontact::mechanics {

struct ScatteredStress::Points {
  ScatteredInterpolation interpolation;
  std::vector<Tensor6> values;
};

ScatteredStress::ScatteredStress(const std::vector<Vector3>& points, std::vector<Tensor6> values)
    : points_(std::make_shared<const Points>(Points{ScatteredInterpolation(points), std::move(values)})) {}

Tensor6 ScatteredStress::operator()(const Vector3& place) const {
  Tensor6 stress = Tensor6::Zero();
  for (const PointWeight& one : points_->interpolation.weights(place))
    stress += one.weight * points_->values[one.point];
  return stress;
}

double ScatteredStress::outside(const Vector3& place) const {
  return points_->interpolation.outside(place).distance;
}

}  // namespace creepcontact::mechanics
