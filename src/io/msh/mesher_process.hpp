#pragma once
/// A .geo meshed in a process of its own.

#include <filesystem>
#include <string>

#include "creepcontact/io/msh/mesher_protocol.hpp"

namespace creepcontact::io {

/// @param time_limit  seconds; 0: none
/// @returns the mesh as .msh; Gmsh's warnings go to the log
/// @throws ModelError with Gmsh's errors, or however the process ended without a mesh
std::string run_mesher(const MesherRequest& request, double time_limit);

/// CREEPCONTACT_MESHER of the environment, else creepcontact-mesher in the directory of this program, else where the
/// installation has put it. @throws ModelError naming all places if it is at none
std::filesystem::path find_mesher();

}  // namespace creepcontact::io
