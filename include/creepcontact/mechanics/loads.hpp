#pragma once
/// External forces of a body. Integrals over space are done once where a load is (function of place) x (function of
/// time); only a load that mixes both is integrated again for a new time.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/mechanics/discretization.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mechanics {

/// Immutable.
class Load {
 public:
  virtual ~Load() = default;
  /// forces += F(t), 3 (n_nodes + n_inner) of the discretization: only loads on the volume act on inner displacements
  virtual void add(double t, std::span<double> forces) const = 0;
};

/// Pressure on faces, positive towards the body. @param pressure of x, y, z, t
std::unique_ptr<Load> pressure_load(const mesh::Mesh& mesh, std::vector<mesh::Face> faces, Function pressure);
/// Force per area with fixed directions. @param traction three functions of x, y, z, t
std::unique_ptr<Load> traction_load(const mesh::Mesh& mesh, std::vector<mesh::Face> faces,
                                    std::array<Function, 3> traction);
/// Force at a node. @param force three functions of t (x, y, z are the node's)
std::unique_ptr<Load> point_load(const mesh::Mesh& mesh, std::int64_t node, std::array<Function, 3> force);
/// Force per volume. @param body  must outlive the load @param force_density  three functions of x, y, z, t
std::unique_ptr<Load> volume_load(const Discretization& body, std::array<Function, 3> force_density);
/// Centrifugal force density * omega^2 * (distance vector from the axis). @param body  must outlive the load
/// @param axis  any length but zero @param angular_velocity  of t [rad/time] @param density  of x, y, z, t
std::unique_ptr<Load> centrifugal_load(const Discretization& body, Vector3 axis, Vector3 origin,
                                       Function angular_velocity, Function density);

/// Unit outward normals at nodes of faces: area-weighted averages over the adjacent faces, each with its own normal at
/// the node. @returns one a node, in the order of `nodes`
/// @throws ModelError if a node lies on none of the faces, or the normals of its faces cancel
std::vector<Vector3> nodal_normals(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces,
                                   const std::vector<std::int64_t>& nodes);

}  // namespace creepcontact::mechanics
