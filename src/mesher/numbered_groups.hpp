#pragma once
/// Groups of a file as numbers of their nodes and elements, which become physical groups.

#include <cstdint>
#include <string>
#include <vector>

#include "creepcontact/io/msh/msh_content.hpp"

namespace creepcontact::mesher {

struct NumberedGroup {
  std::string name;
  std::vector<std::uint64_t> nodes, elements;  ///< numbers
};

/// Makes each of them a physical group, and no others. Elements without a group are dropped; a group of nodes becomes
/// one of points. Where groups share a name, that of nodes is "name (nodes)", and nodes without elements are left out;
/// both with a warning on standard error.
void set_groups(const std::vector<NumberedGroup>& groups, io::MshContent& content);

/// A warning in the form of Gmsh, which the program passes on.
void warn(const std::string& text);

}  // namespace creepcontact::mesher
