#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "creepcontact/base/function.hpp"
#include "creepcontact/mesh/box_tree.hpp"
#include "creepcontact/mesh/surface_patch.hpp"

namespace creepcontact::mesh {
namespace {

constexpr double least_opposition = 0.7071;  // cosine of 45 degrees
constexpr double parallel = 1e-4;            // sine of the angle of axes that are the same

/// The point of a triangle that is nearest to a position (Ericson, Real-Time Collision Detection, 5.1.5).
Vector3 nearest_point(const Facet& facet, const Vector3& p) {
  const auto& [a, b, c] = facet.corners;
  const Vector3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const Vector3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  const Vector3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const double sum = va + vb + vc;
  return a + vb / sum * ab + vc / sum * ac;
}

/// What the facets of one patch see of another one.
struct Sight {
  double area = 0, angle = 0, distance = 0;  // the last two times the area
  double least = std::numeric_limits<double>::infinity(), largest = -least;
};

using Sights = std::map<std::pair<std::size_t, std::size_t>, Sight>;  // by the patch that sees, and the one seen

Sights sights(std::span<const SurfacePatch> patches, std::span<const Vector3> nodes, double distance) {
  std::vector<Facet> facets;
  std::vector<Vector3> normals;
  std::vector<std::size_t> owner;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (const Facet& facet : facets_of(patches[p].faces, nodes)) {
      if (!(facet.area() > 0)) continue;
      facets.push_back(facet);
      normals.push_back(facet.doubled_area().normalized());
      owner.push_back(p);
      Eigen::AlignedBox3d& box = boxes.emplace_back();
      for (const Vector3& corner : facet.corners) box.extend(corner);
    }
  const BoxTree tree(boxes);
  Sights all;
  const Vector3 reach = Vector3::Constant(distance);
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const Vector3 from = facets[f].center();
    struct Nearest {
      double square = std::numeric_limits<double>::infinity(), along = 0, cosine = 0;
    };
    std::map<std::size_t, Nearest> nearest;  // by patch
    for (const std::size_t other : tree.meeting({from - reach, from + reach})) {
      if (patches[owner[other]].body == patches[owner[f]].body) continue;
      const double cosine = -normals[f].dot(normals[other]);
      if (cosine < least_opposition) continue;
      const Vector3 arm = nearest_point(facets[other], from) - from;
      Nearest& known = nearest[owner[other]];
      if (arm.squaredNorm() < known.square) known = {arm.squaredNorm(), arm.dot(normals[f]), cosine};
    }
    for (const auto& [patch, found] : nearest) {
      // What is nearest at its border does not face it.
      if (std::sqrt(found.square) > distance ||
          found.square > 2 * found.along * found.along + 1e-6 * distance * distance)
        continue;
      Sight& sight = all[{owner[f], patch}];
      const double area = facets[f].area();
      sight.area += area;
      sight.angle += area * std::acos(std::min(found.cosine, 1.0));
      sight.distance += area * found.along;
      sight.least = std::min(sight.least, found.along);
      sight.largest = std::max(sight.largest, found.along);
    }
  }
  return all;
}

/// Range of the distances between two shapes, where their kinds tell it.
std::optional<Interval> between_shapes(const SurfaceShape& a, const SurfaceShape& b) {
  if (a.kind != b.kind || a.is_hollow == b.is_hollow) {
    if (a.kind != ShapeKind::plane || b.kind != ShapeKind::plane) return std::nullopt;
    if (a.axis.cross(b.axis).norm() > parallel) return std::nullopt;
    const double distance = a.axis.dot(b.center - a.center);
    return Interval{distance, distance};
  }
  const SurfaceShape &hole = a.is_hollow ? a : b, &shaft = a.is_hollow ? b : a;
  const Vector3 arm = shaft.center - hole.center;
  double offset = arm.norm();
  if (a.kind == ShapeKind::cylinder) {
    if (a.axis.cross(b.axis).norm() > parallel) return std::nullopt;
    offset = (arm - hole.axis.dot(arm) * hole.axis).norm();
  } else if (a.kind != ShapeKind::sphere) {
    return std::nullopt;
  }
  const double clearance = hole.radius - shaft.radius;
  constexpr double rounding = 1e-9;
  if (offset < rounding * hole.radius) offset = 0;
  return Interval{clearance - offset, clearance + offset};
}

}  // namespace

double size_of(std::span<const SurfacePatch> patches) {
  Eigen::AlignedBox3d box;
  for (const SurfacePatch& patch : patches) box.extend(patch.box);
  return box.diagonal().norm();
}

double near_distance(std::span<const SurfacePatch> patches) {
  constexpr double of_model = 0.005, of_body = 0.05;
  std::map<std::string, Eigen::AlignedBox3d> bodies;
  for (const SurfacePatch& patch : patches) bodies[patch.body].extend(patch.box);
  double result = of_model * size_of(patches);
  for (const auto& [name, box] : bodies) result = std::min(result, of_body * box.diagonal().norm());
  return result;
}

double distance_from(const SurfacePatch& patch, std::span<const Vector3> nodes, const Vector3& position,
                     const Vector3& normal) {
  double least = std::numeric_limits<double>::infinity();
  for (const Facet& facet : facets_of(patch.faces, nodes))
    if (facet.doubled_area().normalized().dot(normal) >= least_opposition)
      least = std::min(least, (nearest_point(facet, position) - position).norm());
  return least;
}

std::vector<FacingPatches> facing_patches(std::span<const SurfacePatch> patches, std::span<const Vector3> nodes,
                                          double distance) {
  const Sights all = sights(patches, nodes, distance);
  std::vector<FacingPatches> result;
  for (const auto& [pair, forth] : all) {
    const auto [a, b] = pair;
    const auto back = all.find({b, a});
    if (back != all.end() && a > b) continue;  // done
    // The smaller patch sees the other one with all that faces it.
    const Sight& sight = back == all.end() || patches[a].area <= patches[b].area ? forth : back->second;
    FacingPatches one{.first = std::min(a, b),
                      .second = std::max(a, b),
                      .least = sight.least,
                      .largest = sight.largest,
                      .mean = sight.distance / sight.area,
                      .area = sight.area,
                      .angle = sight.angle / sight.area};
    if (const auto exact = between_shapes(patches[a].shape, patches[b].shape)) {
      one.least = exact->low;
      one.largest = exact->high;
      one.mean = (exact->low + exact->high) / 2;
      one.is_exact = true;
    }
    result.push_back(one);
  }
  std::ranges::sort(result, {}, [](const FacingPatches& one) { return std::pair(one.first, one.second); });
  return result;
}

}  // namespace creepcontact::mesh
