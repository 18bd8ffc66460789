#pragma once
/// Triangles, lines and tetrahedra that show a mesh.

#include <array>
#include <cstdint>
#include <vector>

#include "creepcontact/io/fields/field_writer.hpp"

namespace creepcontact::report {

/// What shows one body. Numbers refer to the points of the mesh.
struct BodyShape {
  std::vector<std::array<std::int64_t, 3>> triangles;   ///< of the surface, outward; of a section the section itself
  std::vector<std::array<std::int64_t, 2>> edges;       ///< edges of the elements there, each once
  std::vector<std::array<std::int64_t, 4>> tetrahedra;  ///< the volume between corners; none in sections
};

/// True if the mesh has no volume cells.
bool is_flat(const io::FieldMesh& mesh);

/// @param body_of  the body of every point @returns one shape per body
/// Faces and elements of second order are divided at their mid-nodes, tetrahedra have the corners alone. Cost: a sort
/// of all faces.
std::vector<BodyShape> shapes(const io::FieldMesh& mesh, const std::vector<std::size_t>& body_of, std::size_t n_bodies);

}  // namespace creepcontact::report
