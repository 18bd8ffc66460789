#pragma once
/// Finds the elements of a mesh that hold points.

#include <optional>
#include <vector>

#include "creepcontact/mesh/box_tree.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::results {

struct PointLocation {
  std::size_t element = 0;             ///< its number among the volume cells of all blocks
  std::vector<std::int64_t> nodes;     ///< of the element
  std::vector<double> weights;         ///< shape functions at the point
  Vector3 position = Vector3::Zero();  ///< the point asked for
  double distance = 0;                 ///< from the point to the element's nearest place
};

class PointLocator {
 public:
  /// @param mesh  must outlive this. Cost: sorts the boxes of the volume cells.
  explicit PointLocator(const mesh::Mesh& mesh);

  /// A point up to a tenth of an element outside the mesh (a curved surface is faceted) is laid onto the nearest
  /// element. @returns nothing for points further away. Cost: a search in a tree of the cells.
  std::optional<PointLocation> locate(const Vector3& at) const;

 private:
  const mesh::Mesh& mesh_;
  mesh::BoxTree cells_;  // as far as points are laid onto them
};

}  // namespace creepcontact::results
