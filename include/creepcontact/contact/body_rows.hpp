#pragma once
/// A body's contact rows on its free unknowns.

#include <vector>

#include "creepcontact/contact/geometry/pair.hpp"

namespace creepcontact::contact {

struct BodyRows {
  std::vector<int> rows;        ///< in the multipliers of all pairs, ascending
  RowMatrix reduced;            ///< B, rows.size() x n_free; entries at the pins of a floating body are left out
  std::vector<char> is_slaves;  ///< of each row: the body is the slave there
};

}  // namespace creepcontact::contact
