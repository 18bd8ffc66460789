#pragma once
/// What the supports tell of planes of symmetry: a direction held at a node is the normal of one.

#include "creepcontact/mechanics/constraints.hpp"

namespace creepcontact::contact {

/// Length of the part of a unit vector that lies in the node's held directions.
double held_part(const Vector3& direction, std::int64_t node, const mechanics::Constraints& constraints);

/// The normal without that part. A normal that is itself held stays what it is.
Vector3 lay_into_symmetry_planes(const Vector3& normal, std::int64_t node, const mechanics::Constraints& constraints);

}  // namespace creepcontact::contact
