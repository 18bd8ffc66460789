#pragma once
/// Two surfaces in contact, by bodies.

#include <span>
#include <string>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/geometry/mortar.hpp"

namespace creepcontact::contact {

struct Pair {
  std::string name;
  std::string slave_surface, master_surface;  ///< empty: ties of nodes (node_ties.hpp)
  std::size_t slave_body = 0, master_body = 0;
  MortarCoupling coupling;
  Function gap;                ///< given initial gap ...
  bool geometric_gap = false;  ///< ... or the one measured from the meshes
  Index first_row = 0;         ///< in the multipliers of all pairs

  bool ties_nodes() const { return slave_surface.empty(); }
};

/// Numbers the rows of all pairs. @returns how many there are
Index number_rows(std::vector<Pair>& pairs);

/// The contact rows of one body, those of all pairs stacked; `rows` receives their numbers.
RowMatrix body_rows(std::span<const Pair> pairs, std::size_t body, std::size_t n_nodes, std::vector<int>& rows);

}  // namespace creepcontact::contact
