#pragma once
/// Quadrature over the part of an element on one side of a surface that cuts it.

#include <Eigen/Core>

#include "creepcontact/fem/reference_element.hpp"

namespace creepcontact::fem {

/// Rule over the part of the reference domain where the interpolated level is positive; without points if it is
/// nowhere. The domain is divided into simplices, and these at the zeros of the level: exact for polynomials of degree
/// 5 where the level is linear in the reference coordinates (a plane through an element with straight edges and
/// parallel faces). Elsewhere simplices are halved up to nine times before the level counts as linear in them.
/// @param levels  at the nodes of the element. Precondition: a line, surface or volume type
QuadratureRule positive_part_rule(const ReferenceElement& element, const Eigen::VectorXd& levels);

}  // namespace creepcontact::fem
