#pragma once
/// Small plane meshes made in code.

#include <array>

#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::test {

/// A rectangle in the plane z = 0, nx x ny grid cells of one element type; a triangle is half of one.
/// Groups: "section", and the curves "x0", "x1", "y0", "y1".
/// @param distortion  corner nodes inside are moved by up to this part of a grid cell (same every time); middle nodes
///                    stay in the middle of their corners
mesh::Mesh section_mesh(mesh::CellType type, std::array<int, 2> divisions, const Eigen::Vector2d& lengths,
                        const Eigen::Vector2d& origin, const mesh::Section& section, double distortion = 0);

}  // namespace creepcontact::test
