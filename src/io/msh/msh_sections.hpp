#pragma once
/// The sections of a .msh file that matter, each from behind its name to before its end.

#include "creepcontact/io/msh/msh_content.hpp"
#include "msh_input.hpp"

namespace creepcontact::io {

// Format 2.2. Elements bear their physical group themselves: each group counts as an entity of its own.
void read_nodes_22(MshInput& input, MshContent& content, bool parametric);
void read_elements_22(MshInput& input, MshContent& content);

// Format 4.1
void read_entities_41(MshInput& input, MshContent& content, bool partitioned);
void read_nodes_41(MshInput& input, MshContent& content);
void read_elements_41(MshInput& input, MshContent& content);

/// @throws ModelError if the program does not know how many nodes such an element has
const struct MshElement& known_element(const MshInput& input, int type);
/// A tag of a physical group: its sign is an orientation that the program does not need.
int read_physical_tag(MshInput& input);
/// Steps over the parameters of a node on an entity of that dimension.
void skip_node_parameters(MshInput& input, int dimension, std::uint64_t n_nodes);

}  // namespace creepcontact::io
