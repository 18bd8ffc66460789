#pragma once
/// What the element tests share: the types, sample points inside the reference domains, domain measures.

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "creepcontact/fem/reference_element.hpp"

namespace creepcontact::fem::testing {

inline const std::vector<CellType> all_types{CellType::line2,  CellType::line3,  CellType::tri3,  CellType::tri6,
                                             CellType::quad4,  CellType::quad8,  CellType::quad9, CellType::tet4,
                                             CellType::tet10,  CellType::hex8,   CellType::hex20, CellType::hex27,
                                             CellType::wedge6, CellType::wedge15};

inline bool simplex_plane(CellType type) {
  const int n = mesh::n_corners(type);
  return (mesh::dimension(type) == 2 && n == 3) || n == 6;
}
inline bool tetrahedral(CellType type) {
  return mesh::dimension(type) == 3 && mesh::n_corners(type) == 4;
}

/// Mean and random weights of the corners: inside every (convex) reference domain.
inline std::vector<Vector3> inner_points(CellType type) {
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

inline Eigen::VectorXd shape_at(const ReferenceElement& element, const Vector3& xi) {
  Eigen::VectorXd shape(element.n_nodes());
  element.shape(xi, shape);
  return shape;
}

inline Eigen::MatrixX3d gradient_at(const ReferenceElement& element, const Vector3& xi) {
  Eigen::MatrixX3d gradient = Eigen::MatrixX3d::Constant(element.n_nodes(), 3, 99);
  element.gradient(xi, gradient);
  return gradient;
}

inline std::string type_name(const ::testing::TestParamInfo<CellType>& info) {
  return std::string(mesh::name(info.param));
}

}  // namespace creepcontact::fem::testing
