#pragma once
/// The contact rows of one body.

#include <cstdint>
#include <vector>

#include "creepcontact/contact/geometry/pair.hpp"

namespace creepcontact::contact {

/// The gaps that displacements of a body open. InterfaceRows makes one per body.
struct BodyRows {
  std::vector<int> rows;               ///< numbers in the multipliers of all pairs, ascending
  RowMatrix full;                      ///< rows.size() x 3 n_nodes
  RowMatrix reduced;                   ///< B, rows.size() x n_free; no entries at fixing dofs
  std::vector<char> is_slaves;         ///< per row: true if the body is the slave there
  std::vector<std::int64_t> trailing;  ///< free dofs that the rows touch, ascending: a factor may eliminate them last
};

}  // namespace creepcontact::contact
