#include "creepcontact/mechanics/element_rotation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <map>

#include "creepcontact/fem/reference_element.hpp"

namespace creepcontact::mechanics {
namespace {

/// Shape functions and their derivatives at the centre of the reference element.
struct Centre {
  Eigen::VectorXd shape;
  Eigen::MatrixX3d gradient;
};

Centre centre_of(mesh::CellType type) {
  const fem::ReferenceElement& element = fem::reference_element(type);
  const Vector3 xi = element.nodes().topRows(mesh::n_corners(type)).colwise().mean().transpose();
  Centre centre{Eigen::VectorXd(element.n_nodes()), Eigen::MatrixX3d::Zero(element.n_nodes(), 3)};
  element.shape(xi, centre.shape);
  element.gradient(xi, centre.gradient);
  return centre;
}

/// The centres of the elements of a body, one after the other.
class Centres {
 public:
  explicit Centres(const Body& body) : discretization_(body.discretization()), nodes_(body.mesh().nodes) {}

  const Centre& of(std::size_t e) {
    const mesh::CellType type = discretization_.element_type(e);
    const auto found = centres_.find(type);
    return found != centres_.end() ? found->second : centres_.emplace(type, centre_of(type)).first->second;
  }
  /// dxi_k/dx_j at the centre.
  Matrix3 inverse_jacobian(std::size_t e) {
    const Centre& centre = of(e);
    const std::span<const std::int64_t> cell = discretization_.element_nodes(e);
    Matrix3 jacobian = Matrix3::Zero();
    for (std::size_t i = 0; i < cell.size(); ++i)
      jacobian += nodes_[cell[i]] * centre.gradient.row(static_cast<Eigen::Index>(i));
    // A section lies in the plane z = 0.
    if (mesh::dimension(discretization_.element_type(e)) == 2) jacobian(2, 2) = 1;
    return jacobian.inverse();
  }

 private:
  const Discretization& discretization_;
  const std::vector<Vector3>& nodes_;
  std::map<mesh::CellType, Centre> centres_;
};

}  // namespace

ElementRotations::ElementRotations(const Body& body) : body_(body) {
  Centres centres(body);
  for (std::size_t e = 0; e < body.discretization().n_elements(); ++e) {
    const Matrix3 inverse = centres.inverse_jacobian(e);
    double sum = 0;
    for (const auto& by_reference : centres.of(e).gradient.rowwise()) sum += (by_reference * inverse).norm();
    slopes_.push_back(sum);
  }
}

ElementRotation ElementRotations::largest(std::span<const double> u, double limit) const {
  const Discretization& discretization = body_.discretization();
  Centres centres(body_);
  ElementRotation largest;
  for (std::size_t e = 0; e < slopes_.size(); ++e) {
    const std::span<const std::int64_t> cell = discretization.element_nodes(e);
    const auto at = [&](std::size_t i) { return Eigen::Map<const Vector3>(&u[3 * cell[i]]); };
    // The gradient is the sum of (u_i - u_0) grad N_i, and half its curl is at most as large.
    double farthest = 0;
    for (std::size_t i = 1; i < cell.size(); ++i) farthest = std::max(farthest, (at(i) - at(0)).squaredNorm());
    const double needed = std::max(limit, largest.angle) / slopes_[e];
    if (!(farthest > needed * needed)) continue;
    const Centre& centre = centres.of(e);
    Matrix3 by_reference = Matrix3::Zero();  // columns: derivatives by xi
    Vector3 position = Vector3::Zero();
    for (std::size_t i = 0; i < cell.size(); ++i) {
      by_reference += at(i) * centre.gradient.row(static_cast<Eigen::Index>(i));
      position += centre.shape[static_cast<Eigen::Index>(i)] * body_.mesh().nodes[cell[i]];
    }
    const Matrix3 gradient = by_reference * centres.inverse_jacobian(e);
    const Vector3 rotation(gradient(2, 1) - gradient(1, 2), gradient(0, 2) - gradient(2, 0),
                           gradient(1, 0) - gradient(0, 1));
    const double angle = rotation.norm() / 2;
    if (angle > std::max(limit, largest.angle)) largest = {angle, position};
  }
  return largest;
}

}  // namespace creepcontact::mechanics
