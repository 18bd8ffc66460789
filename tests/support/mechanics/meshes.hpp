#pragma once
/// Small meshes made in code, for the tests of mechanics and contact.

#include <array>

#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::test {

using mesh::CellType;

/// A box of nx x ny x nz grid cells of one element type.
/// Groups: "volume", and the surfaces "x0", "x1", "y0", "y1", "z0", "z1" with their cells.
/// @param distortion  corner nodes inside the box are moved by up to this part of a grid cell (same every time);
///                    middle nodes stay in the middle of their corners
mesh::Mesh box_mesh(CellType type, std::array<int, 3> divisions, const Vector3& lengths = Vector3::Ones(),
                    const Vector3& origin = Vector3::Zero(), double distortion = 0);

/// The mesh with its nodes moved to map(x); middle nodes too, so that faces may become curved.
template <typename Map>
mesh::Mesh mapped(mesh::Mesh mesh, const Map& map) {
  for (Vector3& x : mesh.nodes) x = map(x);
  return mesh;
}

}  // namespace creepcontact::test
