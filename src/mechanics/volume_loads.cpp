#include <Eigen/LU>
#include <cmath>
#include <functional>
#include <numeric>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/fem/tangents.hpp"
#include "separable_load.hpp"

namespace creepcontact::mechanics {

namespace {

/// Over the volume: the field at the integration points is given.
class VolumeIntegral final : public SpatialIntegral {
 public:
  /// @param field  by the coordinates of a point
  VolumeIntegral(const Discretization& body, std::function<Vector3(const Vector3&)> field)
      : body_(body), nodes_(body.n_nodes() + body.n_inner()), at_(std::move(field)) {
    std::iota(nodes_.begin(), nodes_.end(), 0);
    for (const Vector3& x : body.point_coordinates()) field_.push_back(at_(x));
  }

  const std::vector<std::int64_t>& nodes() const override { return nodes_; }
  void add(const Function& f, double t, std::span<double> values) const override {
    std::vector<Vector3> density = field_;
    for (std::size_t p = 0; p < density.size(); ++p) density[p] *= evaluate(f, body_.point_coordinates()[p], t);
    body_.add_body_force(density, values);
  }

  std::vector<FieldPoint> points_beyond(const Cut& cut) const override {
    std::vector<FieldPoint> beyond;
    const std::span<const double> weights = body_.weights();
    for (std::size_t e = 0; e < body_.n_elements(); ++e) {
      const Cut::Side side = cut.side(body_.element_nodes(e));
      if (side == Cut::Side::both) append_part(cut, e, beyond);
      if (side != Cut::Side::beyond) continue;
      const std::size_t end = e + 1 < body_.n_elements() ? body_.first_point(e + 1) : body_.n_points();
      for (std::size_t p = body_.first_point(e); p < end; ++p)
        beyond.push_back({body_.point_coordinates()[p], weights[p] * field_[p]});
    }
    return beyond;
  }

 private:
  /// Appends the points beyond the plane of an element that it cuts.
  void append_part(const Cut& cut, std::size_t e, std::vector<FieldPoint>& beyond) const {
    const std::span<const std::int64_t> nodes = body_.element_nodes(e);
    const fem::ReferenceElement& element = fem::reference_element(body_.element_type(e));
    const fem::QuadratureRule rule = cut.rule_beyond(element.type(), nodes);
    Eigen::Matrix3Xd x(3, element.n_nodes());
    for (int a = 0; a < element.n_nodes(); ++a) x.col(a) = cut.mesh().nodes[nodes[a]];
    Eigen::VectorXd shape(element.n_nodes());
    Eigen::MatrixX3d gradient(element.n_nodes(), 3);
    for (Index q = 0; q < rule.size(); ++q) {
      const Vector3 xi = rule.points.row(q).transpose();
      element.shape(xi, shape);
      element.gradient(xi, gradient);
      const Vector3 position = x * shape;
      const double volume = rule.weights[q] * cut.mesh().section.depth(position) *
                            std::abs(fem::jacobian(element, x, gradient).determinant());
      beyond.push_back({position, volume * at_(position)});
    }
  }

  const Discretization& body_;
  std::vector<std::int64_t> nodes_;
  std::function<Vector3(const Vector3&)> at_;  // the field, by position
  std::vector<Vector3> field_;                 // at the points
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
  auto integral = std::make_unique<VolumeIntegral>(body, [unit, origin](const Vector3& x) {
    const Vector3 arm = x - origin;
    return Vector3(arm - unit * unit.dot(arm));
  });
  return std::make_unique<SeparableLoad>(std::move(integral), std::move(density), std::move(angular_velocity), 2);
}

}  // namespace creepcontact::mechanics
