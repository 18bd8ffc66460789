#pragma once
/// The faces of a model, before anything is said of it: of CAD, or smooth pieces of the surface of a mesh.

#include <string>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/mesh/surface_patch.hpp"

namespace creepcontact::model {

struct ModelFaces {
  std::vector<Vector3> nodes;
  std::vector<mesh::SurfacePatch> patches;      ///< ascending by number; their bodies are regions
  std::vector<std::string> regions;             ///< solids of CAD, groups of volumes (sections: surfaces) of a mesh
  std::vector<std::vector<mesh::Face>> areas;   ///< by region: the cells of a section; else empty
  std::vector<std::vector<std::string>> names;  ///< by patch: groups of the mesh and [surfaces] that have all of it
  std::vector<mesh::FacingPatches> pairs;
  double distance = 0;       ///< within which pairs were sought
  double size = 0;           ///< diagonal of the model
  int n_loose = 0;           ///< faces of no solid
  std::string unit_of_file;  ///< of lengths, as STEP names it; empty: not known
  std::string unit;          ///< of the lengths here: "mm"; empty: that of the mesh file
};

/// @param config  of which [mesh], [surfaces], `units` and `analysis` count; the cuts do not
/// @param distance  within which faces of different bodies are neighbours; 0: mesh::near_distance
/// @throws ModelError as build_model
ModelFaces model_faces(const config::Config& config, double distance);

/// What a pair of faces is.
enum class Fit { touching, gap, interference };
Fit fit_of(const mesh::FacingPatches& pair, double size);

/// Why a pair may be no contact; empty if nothing speaks against it.
std::string doubt(const mesh::FacingPatches& pair, const ModelFaces& faces);

/// Faces that make small elements: less wide than 0.2 % of the model. @returns indices of patches
std::vector<std::size_t> narrow_faces(const ModelFaces& faces);

}  // namespace creepcontact::model
