#pragma once
/// The multiplier nodes (rows) of a pair as a grid on the slave surface.

#include <array>
#include <vector>

#include "creepcontact/contact/geometry/pair.hpp"

namespace creepcontact::contact {

struct ContactGrid {
  struct Facet {
    std::array<int, 4> rows{};  ///< at its corners
    std::size_t n_corners = 0;
  };

  /// Facets of the slave surface that have a row at each corner; those that the other surface hardly covers have not.
  ContactGrid(const contact::Pair& pair, const mesh::Mesh& slave);

  const Vector3& place(int row) const { return places[static_cast<std::size_t>(row)]; }
  /// Rows that share a facet with a row, itself excepted.
  const std::vector<int>& around(int row) const { return neighbours[static_cast<std::size_t>(row)]; }

  std::vector<Vector3> places;  ///< of each row
  std::vector<Facet> facets;
  std::vector<std::vector<int>> neighbours;  ///< of each row, ascending
};

}  // namespace creepcontact::contact
