#include <numeric>

#include "creepcontact/base/error.hpp"
#include "separable_load.hpp"

namespace creepcontact::mechanics {

namespace {

/// Over the volume: the field at the integration points is given.
class VolumeIntegral final : public SpatialIntegral {
 public:
  /// @param field  of a point's coordinates
  template <typename Field>
  VolumeIntegral(const Discretization& body, const Field& field)
      : body_(body), nodes_(body.n_nodes() + body.n_inner()) {
    std::iota(nodes_.begin(), nodes_.end(), 0);
    for (const Vector3& x : body.point_coordinates()) field_.push_back(field(x));
  }

  const std::vector<std::int64_t>& nodes() const override { return nodes_; }
  void add(const Function& f, double t, std::span<double> values) const override {
    std::vector<Vector3> density = field_;
    for (std::size_t p = 0; p < density.size(); ++p) density[p] *= evaluate(f, body_.point_coordinates()[p], t);
    body_.add_body_force(density, values);
  }

 private:
  const Discretization& body_;
  std::vector<std::int64_t> nodes_;
  std::vector<Vector3> field_;
};

}  // namespace

std::unique_ptr<Load> volume_load(const Discretization& body, std::array<Function, 3> force_density) {
  std::vector<std::unique_ptr<Load>> parts;
  for (int i = 0; i < 3; ++i) {
    Function& component = force_density[i];
    if (component.is_zero()) continue;
    auto integral = std::make_unique<VolumeIntegral>(body, [i](const Vector3&) { return Vector3(Vector3::Unit(i)); });
    parts.push_back(std::make_unique<SeparableLoad>(std::move(integral), std::move(component)));
  }
  return std::make_unique<SumOfLoads>(std::move(parts));
}

std::unique_ptr<Load> centrifugal_load(const Discretization& body, const Vector3& axis, const Vector3& origin,
                                       Function angular_velocity, Function density) {
  if (!(axis.norm() > 0)) throw ModelError("the axis of a rotation must not be (0, 0, 0)");
  const Vector3 unit = axis.normalized();
  auto integral = std::make_unique<VolumeIntegral>(body, [&](const Vector3& x) {
    const Vector3 arm = x - origin;
    return Vector3(arm - unit * unit.dot(arm));
  });
  return std::make_unique<SeparableLoad>(std::move(integral), std::move(density), std::move(angular_velocity), 2);
}

}  // namespace creepcontact::mechanics
