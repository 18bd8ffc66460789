#include "unit/fem/elements.hpp"

#include <random>

namespace creepcontact::fem::testing {

std::vector<CellType> element_types() {
  std::vector<CellType> types = mesh::cell_types();
  std::erase(types, CellType::point1);
  return types;
}

bool simplex_plane(CellType type) {
  const int n = mesh::n_corners(type);
  return (mesh::dimension(type) == 2 && n == 3) || n == 6;
}

bool tetrahedral(CellType type) {
  return mesh::dimension(type) == 3 && mesh::n_corners(type) == 4;
}

std::vector<Vector3> inner_points(CellType type) {
  const auto& corners = reference_element(type).nodes().topRows(mesh::n_corners(type));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.05, 1);
  std::vector<Vector3> points;
  for (int k = 0; k < 8; ++k) {
    Eigen::VectorXd weights = Eigen::VectorXd::NullaryExpr(corners.rows(), [&] { return uniform(random); });
    points.emplace_back(corners.transpose() * (weights / weights.sum()));
  }
  return points;
}

Eigen::VectorXd shape_at(const ReferenceElement& element, const Vector3& xi) {
  Eigen::VectorXd shape(element.n_nodes());
  element.shape(xi, shape);
  return shape;
}

Eigen::MatrixX3d gradient_at(const ReferenceElement& element, const Vector3& xi) {
  Eigen::MatrixX3d gradient = Eigen::MatrixX3d::Constant(element.n_nodes(), 3, 99);
  element.gradient(xi, gradient);
  return gradient;
}

std::string type_name(const ::testing::TestParamInfo<CellType>& info) {
  return std::string(mesh::name(info.param));
}

}  // namespace creepcontact::fem::testing
