#pragma once
/// CAD models (STEP, IGES, BRep) by OpenCASCADE in Gmsh.

#include "creepcontact/io/msh/mesher_protocol.hpp"

namespace creepcontact::mesher {

/// Makes the solids of the file Gmsh's model, cut, with names of surfaces and sizes of elements; meshes nothing.
/// @throws std::string or std::runtime_error from Gmsh; ModelError without solids, or if a cut leaves none
io::CadFacts read_cad(const std::filesystem::path& file, const io::CadRequest& request);

}  // namespace creepcontact::mesher
