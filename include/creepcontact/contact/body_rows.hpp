#pragma once
/// The contact rows of one body, restricted to its free dofs.

#include <vector>

#include "creepcontact/contact/geometry/pair.hpp"

namespace creepcontact::contact {

/// Made by CondensedInterface, one per body.
struct BodyRows {
  std::vector<int> rows;        ///< numbers in the multipliers of all pairs, ascending
  RowMatrix reduced;            ///< B, rows.size() x n_free; no entries at fixing dofs
  std::vector<char> is_slaves;  ///< per row: true if the body is the slave there
};

}  // namespace creepcontact::contact
