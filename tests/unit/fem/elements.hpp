#pragma once
/// What the element tests share: the types, sample points inside the reference domains, domain measures.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "creepcontact/fem/reference_element.hpp"

namespace creepcontact::fem::testing {

/// All but points.
std::vector<CellType> element_types();

bool simplex_plane(CellType type);
bool tetrahedral(CellType type);

/// Mean and random weights of the corners: inside every (convex) reference domain.
std::vector<Vector3> inner_points(CellType type);

Eigen::VectorXd shape_at(const ReferenceElement& element, const Vector3& xi);

Eigen::MatrixX3d gradient_at(const ReferenceElement& element, const Vector3& xi);

std::string type_name(const ::testing::TestParamInfo<CellType>& info);

}  // namespace creepcontact::fem::testing
