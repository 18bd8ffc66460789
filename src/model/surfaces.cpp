#include "surfaces.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "creepcontact/base/unit_system.hpp"
#include "creepcontact/io/msh/cad_reader.hpp"
#include "creepcontact/mesh/mesh.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {
namespace {

constexpr double same_radius = 1e-3;   // relative
constexpr double in_plane = 1e-5;      // of the size of the model: how far faces lie beyond a plane or a box
constexpr double nearest_face = 0.02;  // of the size of the model: between a face after the cut and the same one before
constexpr std::size_t most_told = 8;

/// Which faces a condition leaves, and how to say it.
struct Condition {
  std::string text;
  std::set<int> faces;
};

class SurfaceSearch {
 public:
  SurfaceSearch(const config::Config& config, const std::vector<mesh::SurfacePatch>& patches,
                const std::vector<Vector3>& nodes)
      : config_(config), patches_(patches), nodes_(nodes), tolerance_(in_plane * mesh::size_of(patches)) {
    for (const mesh::SurfacePatch& patch : patches) all_.insert(patch.number);
  }

  std::vector<int> find(const config::Surface& surface) {
    for (const int number : surface.faces)
      if (!all_.contains(number)) throw ModelError(fmt::format("there is no face {}; {}", number, known_faces()));
    std::vector<Condition> conditions;
    if (!surface.faces.empty()) conditions.push_back({"", {surface.faces.begin(), surface.faces.end()}});
    const auto add = [&](std::string text, const auto& holds) {
      Condition& made = conditions.emplace_back(Condition{std::move(text), {}});
      for (const mesh::SurfacePatch& patch : patches_)
        if (holds(patch)) made.faces.insert(patch.number);
    };
    if (surface.kind)
      add("of the kind " + *surface.kind,
          [&](const auto& patch) { return mesh::name_of(patch.shape.kind) == *surface.kind; });
    if (surface.radius)
      add(fmt::format("of the radius {:.6g}", *surface.radius), [&](const auto& patch) {
        return std::abs(patch.shape.radius - *surface.radius) <= same_radius * *surface.radius;
      });
    if (surface.body.given()) {
      require_body(surface.body);
      add(fmt::format("of the body '{}'", surface.body.name),
          [&](const auto& patch) { return is_of(patch, surface.body); });
    }
    if (surface.touches.given()) {
      require_body(surface.touches);
      const std::set<int> touching = faces_next_to(surface.touches);
      add(fmt::format("next to the body '{}'", surface.touches.name),
          [&](const auto& patch) { return touching.contains(patch.number); });
    }
    if (surface.box) {
      const Vector3 room = Vector3::Constant(tolerance_);
      const Eigen::AlignedBox3d box(vector((*surface.box)[0]) - room, vector((*surface.box)[1]) + room);
      add("in the box", [&](const auto& patch) { return box.contains(patch.box); });
    }
    if (surface.plane) {
      const Vector3 normal = vector(surface.plane->normal).normalized(), origin = vector(surface.plane->origin);
      add("in the plane", [&](const auto& patch) { return lies_in(patch, origin, normal); });
    }
    std::set<int> left = all_;
    for (const Condition& condition : conditions)
      std::erase_if(left, [&](int number) { return !condition.faces.contains(number); });
    if (left.empty()) throw ModelError("no face is meant: " + what_holds(conditions) + "; " + known_faces());
    return {left.begin(), left.end()};
  }

 private:
  bool is_of(const mesh::SurfacePatch& patch, const config::Reference& body) const {
    return body_of_region(config_, patch.body) == body.name || patch.body == body.name;
  }
  void require_body(const config::Reference& body) const {
    std::set<std::string> names;
    for (const mesh::SurfacePatch& patch : patches_) {
      if (is_of(patch, body)) return;
      names.insert(body_of_region(config_, patch.body));
    }
    throw ModelError(fmt::format("no body '{}'; the bodies are {}", body.name, fmt::join(names, ", ")));
  }

  std::set<int> faces_next_to(const config::Reference& body) {
    if (!pairs_) pairs_ = mesh::facing_patches(patches_, nodes_, mesh::near_distance(patches_));
    std::set<int> result;
    for (const mesh::FacingPatches& pair : *pairs_) {
      const mesh::SurfacePatch &a = patches_[pair.first], &b = patches_[pair.second];
      if (is_of(a, body)) result.insert(b.number);
      if (is_of(b, body)) result.insert(a.number);
    }
    return result;
  }

  bool lies_in(const mesh::SurfacePatch& patch, const Vector3& origin, const Vector3& normal) const {
    for (const mesh::Face& face : patch.faces)
      for (const std::int64_t node : face.nodes)
        if (std::abs(normal.dot(nodes_[static_cast<std::size_t>(node)] - origin)) > tolerance_) return false;
    return true;
  }

  static std::string what_holds(const std::vector<Condition>& conditions) {
    std::vector<std::string> told;
    for (const Condition& condition : conditions) {
      if (condition.text.empty()) continue;
      told.push_back(fmt::format("{} {} {}", condition.faces.size(),
                                 condition.faces.size() == 1 ? "face is" : "faces are", condition.text));
    }
    return told.empty() ? "the list is empty"
                        : fmt::format("{}{}", fmt::join(told, ", "), told.size() > 1 ? ", and none all of it" : "");
  }

  std::string known_faces() const {
    std::set<double> radii;
    for (const mesh::SurfacePatch& patch : patches_)
      if (patch.shape.radius > 0) radii.insert(std::round(patch.shape.radius * 1e6) / 1e6);
    std::vector<double> first(radii.begin(),
                              std::next(radii.begin(), static_cast<std::ptrdiff_t>(std::min(most_told, radii.size()))));
    return fmt::format("the faces are {} to {}{}; `creepcontact faces` lists them", *all_.begin(), *all_.rbegin(),
                       radii.empty() ? ""
                                     : fmt::format(", with the radii {:.6g}{}", fmt::join(first, ", "),
                                                   radii.size() > most_told ? ", ..." : ""));
  }

  const config::Config& config_;
  const std::vector<mesh::SurfacePatch>& patches_;
  const std::vector<Vector3>& nodes_;
  double tolerance_;
  std::set<int> all_;
  std::optional<std::vector<mesh::FacingPatches>> pairs_;
};

struct CadUnit {
  double metres;
  const char *name, *word;  // of OpenCASCADE, and as configurations have it
};
constexpr CadUnit cad_units[] = {{1, "M", "m"},     {1e-2, "CM", "cm"},     {1e-3, "MM", "mm"},  {1e-6, "UM", "um"},
                                 {1e3, "KM", "km"}, {0.0254, "INCH", "in"}, {0.3048, "FT", "ft"}};

/// Millimetres if nothing is said.
const CadUnit& cad_unit(const config::Config& config) {
  double length = 1e-3;
  try {
    if (!config.units.empty()) length = unit_system(config.units).length;
  } catch (const std::invalid_argument& error) {
    throw ModelError(
        fmt::format("units: {}; a CAD model needs a unit of length, to which it is converted", error.what()));
  }
  for (const CadUnit& unit : cad_units)
    if (std::abs(length / unit.metres - 1) < 1e-9) return unit;
  throw ModelError(fmt::format("{}CAD models are read in m, cm, mm, um, km, in or ft, and 'units' names another length",
                               config.mesh.location.prefix()));
}

/// Number before the cut of each face after it; 0: the cut has made it.
class FaceOrigins {
 public:
  FaceOrigins(const io::CadSurfaces& before, const io::CadSurfaces& after, const std::vector<config::MeshCut>& cuts) {
    const double size = mesh::size_of(before.patches);
    for (const mesh::SurfacePatch& patch : after.patches) {
      const std::optional<std::size_t> cut = cut_of(patch, after.nodes, cuts, in_plane * size);
      if (cut) of_cut_[*cut].push_back(patch.number);
      const mesh::Face& face = patch.faces.front();
      const Vector3 normal = mesh::facets_of({&face, 1}, after.nodes).front().doubled_area().normalized();
      const Vector3& corner = after.nodes[static_cast<std::size_t>(face.nodes.front())];
      double least = nearest_face * size;
      int origin = 0;
      for (const mesh::SurfacePatch& candidate : before.patches) {
        if (candidate.body != patch.body || candidate.box.exteriorDistance(corner) > least) continue;
        const double distance = mesh::distance_from(candidate, before.nodes, corner, normal);
        // A cut may run along a face of the model.
        if (distance >= (cut ? std::min(least, in_plane * size) : least)) continue;
        least = distance;
        origin = candidate.number;
      }
      if (origin > 0) after_[origin].push_back(patch.number);
    }
  }

  std::vector<int> after(const std::vector<int>& numbers) const {
    std::vector<int> result;
    for (const int number : numbers)
      if (const auto found = after_.find(number); found != after_.end())
        result.insert(result.end(), found->second.begin(), found->second.end());
    return result;
  }
  const std::map<std::size_t, std::vector<int>>& of_cuts() const { return of_cut_; }

 private:
  static std::optional<std::size_t> cut_of(const mesh::SurfacePatch& patch, const std::vector<Vector3>& nodes,
                                           const std::vector<config::MeshCut>& cuts, double tolerance) {
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      const auto axis = static_cast<Eigen::Index>(cuts[i].axis);
      const auto is_on = [&](const mesh::Face& face) {
        return std::ranges::all_of(face.nodes, [&](std::int64_t node) {
          return std::abs(nodes[static_cast<std::size_t>(node)][axis] - cuts[i].at) <= tolerance;
        });
      };
      if (std::ranges::all_of(patch.faces, is_on)) return i;
    }
    return std::nullopt;
  }

  std::map<int, std::vector<int>> after_;
  std::map<std::size_t, std::vector<int>> of_cut_;
};

}  // namespace

std::string body_of_region(const config::Config& config, const std::string& region) {
  for (const config::Body& body : config.bodies)
    if (std::ranges::any_of(body.region, [&](const config::Reference& one) { return one.name == region; }))
      return body.name;
  return region;
}

std::map<std::string, std::vector<int>> named_faces(const config::Config& config,
                                                    const std::vector<mesh::SurfacePatch>& patches,
                                                    const std::vector<Vector3>& nodes) {
  ErrorCollector errors;
  SurfaceSearch search(config, patches, nodes);
  std::map<std::string, std::vector<int>> result;
  for (const config::Surface& surface : config.surfaces)
    errors.collect(surface.location, [&] {
      try {
        result[surface.name] = search.find(surface);
      } catch (const ModelError& error) {
        throw ModelError(fmt::format("surface '{}': {}", surface.name, error.what()));
      }
    });
  errors.raise();
  return result;
}

io::CadRequest cad_request(const config::Config& config) {
  io::CadRequest request;
  request.unit = cad_unit(config).name;
  request.metres = cad_unit(config).metres;
  request.size = config.mesh.size.value_or(0);
  request.per_circle = config.mesh.elements_per_circle;
  return request;
}

std::string unit_in_words(const config::Config& config) {
  return cad_unit(config).word;
}

std::vector<mesh::SurfacePatch> patches_of_regions(const mesh::Mesh& mesh) {
  std::vector<mesh::SurfacePatch> patches;
  for (const auto& [name, group] : mesh.groups) {
    if (group.dimension != mesh.section.dimension()) continue;
    mesh::BodyMesh body = mesh::extract(mesh, {name});
    for (mesh::SurfacePatch& patch :
         mesh::smooth_patches(body.mesh, name, static_cast<int>(patches.size()) + 1, mesh::sharp_edge)) {
      for (mesh::Face& face : patch.faces)
        for (std::int64_t& node : face.nodes) node = body.parent_node[static_cast<std::size_t>(node)];
      patches.push_back(std::move(patch));
    }
  }
  return patches;
}

void add_surfaces(const config::Config& config, mesh::Mesh& mesh) {
  if (config.surfaces.empty()) return;
  const std::vector<mesh::SurfacePatch> patches = patches_of_regions(mesh);
  const std::map<std::string, std::vector<int>> named = named_faces(config, patches, mesh.nodes);
  std::map<mesh::CellType, std::size_t> blocks;
  for (const auto& [name, numbers] : named) {
    if (mesh.groups.contains(name))
      throw ModelError(fmt::format("surface '{}': the mesh has a group of that name; choose another", name));
    mesh::Group group{name, mesh.section.dimension() - 1, {}};
    for (const int number : numbers)
      for (const mesh::Face& face : patches[static_cast<std::size_t>(number) - 1].faces) {
        const auto [found, is_new] = blocks.emplace(face.type, mesh.blocks.size());
        if (is_new) mesh.blocks.push_back({face.type, {}});
        mesh::CellBlock& block = mesh.blocks[found->second];
        group.cells.push_back({found->second, block.size()});
        block.connectivity.insert(block.connectivity.end(), face.nodes.begin(), face.nodes.end());
      }
    mesh.groups.emplace(name, std::move(group));
  }
}

mesh::Mesh read_cad_mesh(const config::Config& config) {
  const config::Mesh& given = config.mesh;
  if (config.analysis != settings::Analysis::solid)
    throw ModelError(
        fmt::format("{}CAD models are solids; a section is a .geo or a mesh of its plane", given.location.prefix()));
  io::CadRequest request = cad_request(config);
  const io::CadLimits limits{given.time_limit, given.memory_limit_mb};
  const io::CadSurfaces before = io::read_cad_surfaces(given.file, request, limits);
  const std::map<std::string, std::vector<int>> named = named_faces(config, before.patches, before.nodes);
  for (const config::MeshCut& cut : given.cut)
    request.cuts.push_back({static_cast<int>(cut.axis), cut.at, cut.keep == config::KeptSide::larger});
  const io::CadSurfaces after = request.cuts.empty() ? before : io::read_cad_surfaces(given.file, request, limits);
  std::optional<FaceOrigins> origins;
  if (!request.cuts.empty()) origins.emplace(before, after, given.cut);
  for (const auto& [name, numbers] : named) {
    const std::vector<int> left = origins ? origins->after(numbers) : numbers;
    if (left.empty())
      log::warning("surface '{}': the cuts of the model leave nothing of it", name);
    else
      request.surfaces[name] = left;
  }
  if (origins)
    for (const auto& [cut, faces] : origins->of_cuts()) {
      const std::string name = fmt::format("cut_{}", settings::name_of(given.cut[cut].axis));
      std::vector<int>& all = request.surfaces[name];
      all.insert(all.end(), faces.begin(), faces.end());
    }
  for (const config::MeshSize& size : given.sizes) {
    io::CadRequest::Size& made = request.sizes.emplace_back();
    made.size = size.size;
    if (size.on.given()) {
      const auto found = request.surfaces.find(size.on.name);
      if (found == request.surfaces.end())
        throw ModelError(
            fmt::format("{}mesh.sizes: no surface '{}' in [surfaces]", size.on.location.prefix(), size.on.name));
      made.faces = found->second;
    } else {
      for (const io::CadFacts::Solid& solid : after.solids)
        if (body_of_region(config, solid.name) == size.body.name) made.solids.push_back(solid.number);
      if (made.solids.empty())
        throw ModelError(fmt::format("{}mesh.sizes: no body '{}'", size.body.location.prefix(), size.body.name));
    }
  }
  return io::mesh_cad(given.file, request, given.order, limits);
}

}  // namespace creepcontact::model
