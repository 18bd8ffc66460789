#pragma once
/// [surfaces.<name>]: which faces of a model a name means.

#include <map>
#include <string>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/io/msh/mesher_protocol.hpp"
#include "creepcontact/mesh/surface_patch.hpp"

namespace creepcontact::model {

/// Body of the configuration whose regions have a region; the region itself if there is none.
std::string body_of_region(const config::Config& config, const std::string& region);

/// Numbers of faces by the names of surfaces. @param patches  their bodies are regions
/// @throws ModelError naming the place of each surface that means nothing, and what the faces are
std::map<std::string, std::vector<int>> named_faces(const config::Config& config,
                                                    const std::vector<mesh::SurfacePatch>& patches,
                                                    const std::vector<Vector3>& nodes);

/// The request for a CAD model, without cuts and names. @throws ModelError for a unit that CAD has not
io::CadRequest cad_request(const config::Config& config);
/// The unit of the lengths of a CAD model: "mm".
std::string unit_in_words(const config::Config& config);

/// The smooth pieces of the surfaces of all regions, numbered from 1 on; their nodes are those of the mesh.
std::vector<mesh::SurfacePatch> patches_of_regions(const mesh::Mesh& mesh);

/// Adds the surfaces of the configuration to the groups of a mesh.
void add_surfaces(const config::Config& config, mesh::Mesh& mesh);

/// Mesh of a CAD model, with the surfaces of the configuration and of the cuts.
mesh::Mesh read_cad_mesh(const config::Config& config);

}  // namespace creepcontact::model
