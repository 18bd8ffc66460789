#pragma once
/// Convex polygons in a plane: the overlap of projected faces.

#include <Eigen/Core>
#include <vector>

namespace creepcontact::contact {

/// Corners in order.
using Polygon = std::vector<Eigen::Vector2d>;

/// Signed area, positive for counter-clockwise order.
double area(const Polygon& polygon);

/// Intersection of two convex counter-clockwise polygons (Sutherland and Hodgman 1974); empty if they do not overlap.
/// @param result  overwritten; @param work  scratch
void clip(const Polygon& subject, const Polygon& window, Polygon& result, Polygon& work);

}  // namespace creepcontact::contact
