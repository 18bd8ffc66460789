#pragma once
/// CAD models (STEP, IGES, BRep), which creepcontact-mesher reads by OpenCASCADE and meshes.

#include <filesystem>
#include <string>
#include <vector>

#include "creepcontact/io/msh/mesher_protocol.hpp"
#include "creepcontact/mesh/surface_patch.hpp"

namespace creepcontact::io {

struct CadLimits {
  double time_limit = 0;    ///< [s]; 0: none
  int memory_limit_mb = 0;  ///< [MB]; 0: none
};

/// The faces of a model, on a coarse mesh of them.
struct CadSurfaces {
  std::vector<Vector3> nodes;
  std::vector<mesh::SurfacePatch> patches;  ///< by their numbers; their bodies are the names of the solids
  std::vector<CadFacts::Solid> solids;
  int n_loose = 0;           ///< faces of no solid, which are left out
  std::string unit_of_file;  ///< as STEP names it, "millimetre", "inch"; empty: it is not known
};

/// @param request  its unit and cuts count. @throws ModelError if the file cannot be read, as read_mesh
CadSurfaces read_cad_surfaces(const std::filesystem::path& file, CadRequest request, const CadLimits& limits);

/// The mesh of the solids, which are its regions by their names, with the surfaces of the request.
mesh::Mesh mesh_cad(const std::filesystem::path& file, const CadRequest& request, int order, const CadLimits& limits);

/// The unit of length of a STEP file; empty if it says none, or several.
std::string unit_of_step(std::string_view text);

}  // namespace creepcontact::io
