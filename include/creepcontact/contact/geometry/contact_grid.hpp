#pragma once
/// The multiplier nodes (rows) of a unilateral pair as a grid of facets on the slave surface.

#include <array>
#include <vector>

#include "creepcontact/contact/geometry/pair.hpp"

namespace creepcontact::contact {

/// Rows at the corners of facets, and their neighbours.
struct ContactGrid {
  struct Facet {
    std::array<int, 4> rows{};         ///< row at each corner
    std::array<Vector3, 4> positions;  ///< of the corners; those of a strip (Facet) lie off the plane z = 0
    std::size_t n_corners = 0;
  };

  /// Takes the facets of the slave surface with a row at every corner; those that the master hardly covers are left
  /// out.
  ContactGrid(const contact::Pair& pair, const mesh::Mesh& slave);

  const Vector3& position(int row) const { return positions[row]; }
  /// Rows that share a facet with this row, without the row itself.
  const std::vector<int>& around(int row) const { return neighbours[row]; }

  std::vector<Vector3> positions;  ///< per row
  std::vector<Facet> facets;
  std::vector<std::vector<int>> neighbours;  ///< per row, ascending
};

}  // namespace creepcontact::contact
