#pragma once
/// Reference coordinates of the nodes in Gmsh's order.

#include "creepcontact/base/tensor.hpp"
#include "creepcontact/mesh/cell_type.hpp"

namespace creepcontact::fem {

/// n_nodes x 3, unused coordinates zero. Source: Gmsh reference manual, "Node ordering".
Eigen::MatrixX3d reference_nodes(mesh::CellType type);

}  // namespace creepcontact::fem
