#pragma once
/// Smooth pieces of the surfaces of bodies, such as the faces of a CAD model, and where those of two bodies face each
/// other.

#include <Eigen/Geometry>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "creepcontact/mesh/mesh.hpp"
#include "creepcontact/mesh/surface_shape.hpp"

namespace creepcontact::mesh {

struct SurfacePatch {
  int number = 0;           ///< by which users name it
  std::string body;         ///< region of the volumes that it bounds
  std::vector<Face> faces;  ///< outward, in sections edges
  SurfaceShape shape = {};
  double area = 0;
  double perimeter = 0;  ///< of its border
  Eigen::AlignedBox3d box = {};
  Vector3 normal = Vector3::Zero();  ///< mean over the area, of length 1; zero where the normals cancel
  Vector3 center = Vector3::Zero();  ///< a point on it, in the middle of its largest face
};

/// Flat triangles between the corners of faces; an edge of a section becomes a strip of the width 1 across the plane.
std::vector<Facet> facets_of(std::span<const Face> faces, std::span<const Vector3> nodes);

/// @param faces  one at least
SurfacePatch surface_patch(int number, std::string body, std::vector<Face> faces, std::span<const Vector3> nodes);

/// The usual angle of smooth_patches() [rad]: 40 degrees, more than facets of curved surfaces have between them.
inline constexpr double sharp_edge = 40 * std::numbers::pi / 180;

/// The pieces of the surface of a body between edges at which the normal turns by more than `angle` [rad], or at which
/// a group of the mesh ends, numbered from `first` on, in the order of their first faces. Cost: a sort of all faces,
/// and a fit for each piece
std::vector<SurfacePatch> smooth_patches(const Mesh& body, const std::string& name, int first, double angle);

/// Diagonal of the box around all of them.
double size_of(std::span<const SurfacePatch> patches);

/// The distance within which surfaces are taken to be next to each other if nothing is said: half a per cent of the
/// diagonal of the model, at most a twentieth of that of the smallest body.
double near_distance(std::span<const SurfacePatch> patches);

/// Distance of a position from the nearest facet of a patch whose normal is that direction, within 45 degrees; infinite
/// if there is none.
double distance_from(const SurfacePatch& patch, std::span<const Vector3> nodes, const Vector3& position,
                     const Vector3& normal);

/// Where two patches of different bodies face each other, with normals that are opposite within 45 degrees.
struct FacingPatches {
  std::size_t first = 0, second = 0;  ///< indices, ascending
  double least = 0, largest = 0;      ///< distance along the normal, negative where the bodies overlap
  double mean = 0;                    ///< over the area
  double area = 0;                    ///< of the part of the smaller patch that faces the other one
  double angle = 0;                   ///< mean angle between the one normal and the opposite of the other [rad]
  /// Both are planes, or cylinders or spheres about one axis or centre: the distances are those of the shapes, not of
  /// facets.
  bool is_exact = false;
};

/// Pairs within a distance, by the indices of their patches. Cost: a search in a tree of boxes per facet
std::vector<FacingPatches> facing_patches(std::span<const SurfacePatch> patches, std::span<const Vector3> nodes,
                                          double distance);

}  // namespace creepcontact::mesh
