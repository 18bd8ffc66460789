#pragma once
/// The multiplier nodes (rows) of a unilateral pair as a grid of facets on the slave surface.

#include <array>
#include <optional>
#include <vector>

#include "creepcontact/contact/geometry/pair.hpp"

namespace creepcontact::contact {

/// Rows at the corners of facets, and their neighbours. With cyclic symmetry the rows are followed by their images in
/// the adjacent sectors, so that no row ends at a face of the sector.
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
  /// The row of the pair that this one is an image of.
  int own(int row) const { return row % n_own; }
  /// Values of the rows of the pair, of all rows. @param of_own  n_own
  Eigen::VectorXd of_all(const Eigen::VectorXd& of_own) const;
  /// The image of a point of this sector that lies nearest to a row.
  Vector3 image_near(int row, const Vector3& point) const;

  int n_own = 0;                             ///< multiplier nodes of the pair
  std::vector<Vector3> positions;            ///< per row
  std::vector<Facet> facets;                 ///< of this sector
  std::vector<std::vector<int>> neighbours;  ///< per row, ascending
  std::optional<Sector> sector;
};

}  // namespace creepcontact::contact
