#pragma once
/// The smooth surface that a linear face represents.

#include "creepcontact/contact/geometry/facet.hpp"

namespace creepcontact::contact {

/// A linear face as a quadratic one, tri6 or quad9, through the same corners and perpendicular to the normals there:
/// the edges bulge as circular arcs do, exact on circles and of third order elsewhere, as Nagata's patches (T. Nagata,
/// Simple local interpolation of surfaces using normal vectors, Comput. Aided Geom. Des. 22 (2005)), but without their
/// singularity where an edge turns. Where one end of an edge is straight, as next to a kink, the edge is.
/// A quadratic face is returned as it is.
/// @param normals  one per node
Facet smooth_facet(const Facet& facet, const std::vector<Vector3>& normals);

}  // namespace creepcontact::contact
