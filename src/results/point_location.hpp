#pragma once
/// Finds the element of a mesh that holds a point.

#include <optional>
#include <vector>

#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::results {

struct PointLocation {
  std::size_t element = 0;          ///< its number among the volume cells of all blocks
  std::vector<std::int64_t> nodes;  ///< of the element
  std::vector<double> weights;      ///< shape functions at the point
  Vector3 place = Vector3::Zero();  ///< the point asked for
  double distance = 0;              ///< from the point to the element's nearest place
};

/// A point up to a tenth of an element outside the mesh (a curved surface is faceted) is laid onto the nearest element.
/// @returns nothing for points further away. Cost: a box test an element.
std::optional<PointLocation> locate(const mesh::Mesh& mesh, const Vector3& at);

}  // namespace creepcontact::results
