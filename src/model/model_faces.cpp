#include "creepcontact/model/model_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/io/msh/cad_reader.hpp"
#include "creepcontact/mesh/outer_faces.hpp"
#include "creepcontact/settings/mesh_formats.hpp"
#include "model_parts.hpp"
#include "surfaces.hpp"

namespace creepcontact::model {
namespace {

constexpr double no_distance = 1e-6;    // of the size of the model
constexpr double of_facets = 0.3;       // of the range of distances, between facets of curved faces that touch
constexpr double narrow = 2e-3;         // of the size of the model
constexpr double most_angle = 10;       // degrees
constexpr double least_overlap = 0.05;  // of the smaller face
constexpr double far_share = 0.5;       // of the distance within which pairs are sought

/// All cells of the face are in the group.
bool has_all(const std::set<std::vector<std::int64_t>>& group, const mesh::SurfacePatch& patch) {
  return std::ranges::all_of(patch.faces,
                             [&](const mesh::Face& face) { return group.contains(mesh::corners_of(face)); });
}

}  // namespace

ModelFaces model_faces(const config::Config& config, double distance) {
  ModelFaces result;
  if (settings::is_cad_file(config.mesh.file.extension().string())) {
    io::CadSurfaces read = io::read_cad_surfaces(config.mesh.file, cad_request(config),
                                                 {config.mesh.time_limit, config.mesh.memory_limit_mb});
    result.nodes = std::move(read.nodes);
    result.patches = std::move(read.patches);
    for (const io::CadFacts::Solid& solid : read.solids) result.regions.push_back(solid.name);
    result.n_loose = read.n_loose;
    result.unit_of_file = read.unit_of_file;
    result.unit = unit_in_words(config);
    result.names.resize(result.patches.size());
  } else {
    config::Config without_names = config;
    without_names.surfaces.clear();
    mesh::Mesh mesh = read_mesh(without_names);
    result.patches = patches_of_regions(mesh);
    for (const auto& [name, group] : mesh.groups)
      if (group.dimension == mesh.section.dimension()) {
        result.regions.push_back(name);
        if (group.dimension == 2) result.areas.push_back(mesh::cells_of_group(mesh, group));
      }
    result.names.resize(result.patches.size());
    for (const auto& [name, group] : mesh.groups) {
      if (group.dimension != mesh.section.dimension() - 1) continue;
      std::set<std::vector<std::int64_t>> cells;
      for (const mesh::Face& face : mesh::cells_of_group(mesh, group)) cells.insert(mesh::corners_of(face));
      for (std::size_t p = 0; p < result.patches.size(); ++p)
        if (has_all(cells, result.patches[p])) result.names[p].push_back(name);
    }
    result.nodes = std::move(mesh.nodes);
  }
  for (const auto& [name, numbers] : named_faces(config, result.patches, result.nodes))
    for (std::size_t p = 0; p < result.patches.size(); ++p)
      if (std::ranges::find(numbers, result.patches[p].number) != numbers.end()) result.names[p].push_back(name);
  result.size = mesh::size_of(result.patches);
  result.distance = distance > 0 ? distance : mesh::near_distance(result.patches);
  result.pairs = mesh::facing_patches(result.patches, result.nodes, result.distance);
  return result;
}

Fit fit_of(const mesh::FacingPatches& pair, double size) {
  const double noise = no_distance * size + (pair.is_exact ? 0 : of_facets * (pair.largest - pair.least));
  if (std::abs(pair.mean) <= noise) return Fit::touching;
  return pair.mean > 0 ? Fit::gap : Fit::interference;
}

std::string doubt(const mesh::FacingPatches& pair, const ModelFaces& faces) {
  const double angle = pair.angle * 180 / std::numbers::pi;
  const double smaller = std::min(faces.patches[pair.first].area, faces.patches[pair.second].area);
  if (!pair.is_exact && angle > most_angle) return fmt::format("the faces are not parallel: {:.3g} degrees", angle);
  if (pair.area < least_overlap * smaller)
    return fmt::format("only {:.2g} % of the smaller face faces the other one", 100 * pair.area / smaller);
  if (std::abs(pair.mean) > far_share * faces.distance) return fmt::format("the distance is {:.4g}", pair.mean);
  return "";
}

std::vector<std::size_t> narrow_faces(const ModelFaces& faces) {
  std::vector<std::size_t> result;
  for (std::size_t p = 0; p < faces.patches.size(); ++p) {
    const mesh::SurfacePatch& patch = faces.patches[p];
    if (patch.perimeter > 0 && 2 * patch.area / patch.perimeter < narrow * faces.size) result.push_back(p);
  }
  return result;
}

}  // namespace creepcontact::model
