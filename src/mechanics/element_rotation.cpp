#include "creepcontact/mechanics/element_rotation.hpp"

#include <Eigen/Dense>
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

}  // namespace

ElementRotation largest_rotation(const Body& body, std::span<const double> u) {
  const Discretization& discretization = body.discretization();
  const std::vector<Vector3>& nodes = body.mesh().nodes;
  std::map<mesh::CellType, Centre> centres;
  ElementRotation largest;
  for (std::size_t e = 0; e < discretization.n_elements(); ++e) {
    const mesh::CellType type = discretization.element_type(e);
    const auto found = centres.find(type);
    const Centre& centre =
        found != centres.end() ? found->second : centres.emplace(type, centre_of(type)).first->second;
    Matrix3 jacobian = Matrix3::Zero(), by_reference = Matrix3::Zero();  // columns: derivatives by xi
    Vector3 position = Vector3::Zero();
    const std::span<const std::int64_t> cell = discretization.element_nodes(e);
    for (Eigen::Index i = 0; i < centre.shape.size(); ++i) {
      const Vector3& x = nodes[cell[i]];
      jacobian += x * centre.gradient.row(i);
      by_reference += Eigen::Map<const Vector3>(&u[3 * cell[i]]) * centre.gradient.row(i);
      position += centre.shape[i] * x;
    }
    if (mesh::dimension(type) == 2) jacobian(2, 2) = 1;  // a section lies in the plane z = 0
    const Matrix3 gradient = by_reference * jacobian.inverse();
    const Vector3 rotation(gradient(2, 1) - gradient(1, 2), gradient(0, 2) - gradient(2, 0),
                           gradient(1, 0) - gradient(0, 1));
    if (const double angle = rotation.norm() / 2; angle > largest.angle) largest = {angle, position};
  }
  return largest;
}

}  // namespace creepcontact::mechanics
