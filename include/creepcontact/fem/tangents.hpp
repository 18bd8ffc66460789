#pragma once
/// Tangents of cells and of the faces that bound them. Sections are taken as deep as the unit of length along z.

#include "creepcontact/fem/reference_element.hpp"

namespace creepcontact::fem {

/// dx_i / dxi_k at a point of a cell that carries material; of the surface cell of a section the third column is the
/// unit vector along z. @param x  coordinates, 3 x n_nodes @param gradient  of the shape functions, n_nodes x 3
Matrix3 jacobian(const ReferenceElement& cell, const Eigen::Matrix3Xd& x, const Eigen::MatrixX3d& gradient);

/// Normal times the area per unit of the reference coordinates, at a point of a face of a solid; or of an edge of a
/// section, per unit of depth. Its direction follows the right-hand rule; an edge has its section on the left.
Vector3 area_vector(const ReferenceElement& face, const Eigen::Matrix3Xd& x, const Eigen::MatrixX3d& gradient);

}  // namespace creepcontact::fem
