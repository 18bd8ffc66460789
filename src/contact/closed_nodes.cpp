#include "creepcontact/contact/closed_nodes.hpp"

#include <algorithm>

namespace creepcontact::contact {

bool is_closed(const Pair& pair, std::size_t node, const ContactState& state) {
  return std::ranges::binary_search(state.active, static_cast<int>(pair.first_row + pair.coupling.row(node)));
}

std::vector<char> closed_nodes(const Pair& pair, const ContactState& state) {
  std::vector<char> closed(pair.coupling.nodes.size());
  for (std::size_t node = 0; node < closed.size(); ++node) closed[node] = is_closed(pair, node, state) ? 1 : 0;
  return closed;
}

}  // namespace creepcontact::contact
