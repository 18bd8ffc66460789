#include "creepcontact/mesh/surface_patch.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string_view>
#include <utility>

#include "creepcontact/base/disjoint_sets.hpp"
#include "creepcontact/mesh/outer_faces.hpp"

namespace creepcontact::mesh {
namespace {

using Border = std::pair<std::int64_t, std::int64_t>;  // the corners of an edge, ascending; of a point twice the node

/// What borders a face: the edges of a surface, the ends of an edge of a section.
std::vector<Border> borders(const Face& face) {
  const auto n = static_cast<std::size_t>(n_corners(face.type));
  std::vector<Border> result;
  if (n == 2) return {{face.nodes[0], face.nodes[0]}, {face.nodes[1], face.nodes[1]}};
  for (std::size_t i = 0; i < n; ++i) result.emplace_back(std::minmax(face.nodes[i], face.nodes[(i + 1) % n]));
  return result;
}

Vector3 doubled_area(const Face& face, std::span<const Vector3> nodes) {
  Vector3 sum = Vector3::Zero();
  for (const Facet& facet : facets_of({&face, 1}, nodes)) sum += facet.doubled_area();
  return sum;
}

/// The groups of each face, by its corners.
std::map<std::vector<std::int64_t>, std::vector<std::string_view>> groups_of_faces(const Mesh& body) {
  std::map<std::vector<std::int64_t>, std::vector<std::string_view>> result;
  for (const auto& [name, group] : body.groups) {
    if (group.dimension != body.section.dimension() - 1) continue;
    for (const Face& face : cells_of_group(body, group)) result[corners_of(face)].push_back(name);
  }
  return result;
}

}  // namespace

std::vector<Facet> facets_of(std::span<const Face> faces, std::span<const Vector3> nodes) {
  std::vector<Facet> result;
  for (const Face& face : faces) {
    const auto at = [&](std::size_t i) -> const Vector3& { return nodes[static_cast<std::size_t>(face.nodes[i])]; };
    const auto n = static_cast<std::size_t>(n_corners(face.type));
    if (n == 2) {
      // The cell is on the left of the edge: outward is to its right.
      const Vector3 half = Vector3::UnitZ() / 2;
      result.push_back({{at(0) - half, at(1) - half, at(1) + half}});
      result.push_back({{at(0) - half, at(1) + half, at(0) + half}});
      continue;
    }
    for (std::size_t i = 1; i + 1 < n; ++i) result.push_back({{at(0), at(i), at(i + 1)}});
  }
  return result;
}

SurfacePatch surface_patch(int number, std::string body, std::vector<Face> faces, std::span<const Vector3> nodes) {
  SurfacePatch patch{.number = number, .body = std::move(body), .faces = std::move(faces)};
  const std::vector<Facet> facets = facets_of(patch.faces, nodes);
  patch.shape = fit_shape(facets);
  const bool is_line = dimension(patch.faces.front().type) == 1;
  // A line of a section is straight, an arc or neither.
  if (is_line && patch.shape.kind != ShapeKind::plane && patch.shape.kind != ShapeKind::cylinder) patch.shape = {};
  Vector3 sum = Vector3::Zero();
  double largest = -1;
  for (const Facet& facet : facets) {
    const double area = facet.area();
    patch.area += area;
    sum += facet.doubled_area() / 2;
    if (area > largest) {
      largest = area;
      patch.center = facet.center();
    }
  }
  if (is_line) patch.center.z() = patch.shape.center.z() = 0;
  constexpr double cancelled = 1e-6;
  if (sum.norm() > cancelled * patch.area) patch.normal = sum.normalized();
  std::map<Border, int> count;
  for (const Face& face : patch.faces) {
    for (const std::int64_t node : face.nodes) patch.box.extend(nodes[static_cast<std::size_t>(node)]);
    for (const Border& border : borders(face)) ++count[border];
  }
  for (const auto& [border, times] : count)
    if (times == 1)
      patch.perimeter +=
          (nodes[static_cast<std::size_t>(border.first)] - nodes[static_cast<std::size_t>(border.second)]).norm();
  return patch;
}

std::vector<SurfacePatch> smooth_patches(const Mesh& body, const std::string& name, int first, double angle) {
  const std::vector<Face> faces = outer_faces(body.blocks, body.section.dimension());
  std::vector<Vector3> normals;
  normals.reserve(faces.size());
  for (const Face& face : faces) normals.push_back(doubled_area(face, body.nodes).normalized());
  std::map<Border, std::vector<std::size_t>> at;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (const Border& border : borders(faces[f])) at[border].push_back(f);
  const auto groups = groups_of_faces(body);
  const std::vector<std::string_view> none;
  std::vector<const std::vector<std::string_view>*> groups_of;
  groups_of.reserve(faces.size());
  for (const Face& face : faces) {
    const auto found = groups.find(corners_of(face));
    groups_of.push_back(found == groups.end() ? &none : &found->second);
  }
  DisjointSets sets(faces.size());
  const double least_cosine = std::cos(angle);
  for (const auto& [border, both] : at)
    if (both.size() == 2 && normals[both[0]].dot(normals[both[1]]) >= least_cosine &&
        *groups_of[both[0]] == *groups_of[both[1]])
      sets.join(both[0], both[1]);
  std::vector<std::vector<Face>> parts;
  std::map<std::size_t, std::size_t> part_of;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto [found, is_new] = part_of.emplace(sets.find(f), parts.size());
    if (is_new) parts.emplace_back();
    parts[found->second].push_back(faces[f]);
  }
  std::vector<SurfacePatch> result;
  result.reserve(parts.size());
  for (std::vector<Face>& part : parts)
    result.push_back(surface_patch(first + static_cast<int>(result.size()), name, std::move(part), body.nodes));
  return result;
}

}  // namespace creepcontact::mesh
