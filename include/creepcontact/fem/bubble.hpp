#pragma once
/// Inner displacement functions ("bubbles") of quadratic tetrahedra, wedges and triangles. If the volumetric strain is
/// projected on linear functions, the pressure needs one more displacement vector per element to be stable (inf-sup
/// condition). A bubble provides it without a node: it vanishes on all faces, so meshes, surface loads and contact are
/// not affected. tet10: l1 l2 l3 l4, wedge15: l1 l2 l3 (1 - z^2), tri6 (in sections): l1 l2 l3 in natural coordinates,
/// scaled to 1 at the middle of the element. Source: Arnold, Brezzi and Fortin (1984).

#include "creepcontact/base/tensor.hpp"
#include "creepcontact/mesh/cell_type.hpp"

namespace creepcontact::fem {

/// True for tet10, wedge15 and tri6.
bool has_bubble(mesh::CellType type);

/// Value at the reference coordinates xi. @throws std::invalid_argument for a type without a bubble
double bubble_value(mesh::CellType type, const Vector3& xi);

/// Derivatives with respect to the reference coordinates xi. @throws std::invalid_argument for a type without a bubble
Vector3 bubble_gradient(mesh::CellType type, const Vector3& xi);

}  // namespace creepcontact::fem
