#pragma once
/// Groups of nodes and elements in a .unv file. Gmsh reads those that it has written itself, and no others.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "creepcontact/io/msh/msh_content.hpp"

namespace creepcontact::mesher {

struct UnvGroup {
  std::string name;
  std::vector<std::uint64_t> nodes, elements;  ///< numbers
};

/// Those of the datasets 2429, 2430, 2432, 2435, 2452, 2467 and 2477, as Salome and I-deas write them; lines that are
/// none are left out.
std::vector<UnvGroup> unv_groups(const std::filesystem::path& file);

/// Makes each of them a physical group, and no others. Elements without a group are dropped; a group of nodes becomes
/// one of points. Where groups share a name, that of nodes is "name (nodes)", and nodes without elements are left out;
/// both with a warning on standard error.
void set_groups(const std::vector<UnvGroup>& groups, io::MshContent& content);

}  // namespace creepcontact::mesher
