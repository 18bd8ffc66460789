#pragma once
/// Groups of nodes and elements in a .unv file. Gmsh reads those that it has written itself, and no others.

#include <filesystem>
#include <vector>

#include "numbered_groups.hpp"

namespace creepcontact::mesher {

/// Those of the datasets 2429, 2430, 2432, 2435, 2452, 2467 and 2477, as Salome and I-deas write them; lines that are
/// none are left out.
std::vector<NumberedGroup> unv_groups(const std::filesystem::path& file);

}  // namespace creepcontact::mesher
