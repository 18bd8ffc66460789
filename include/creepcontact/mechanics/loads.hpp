#pragma once
/// External forces of a body. If a load is (function of position) x (function of time), it is integrated over space
/// only once; any other load is integrated for each new time.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/mechanics/cut.hpp"
#include "creepcontact/mechanics/discretization.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mechanics {

/// One load of a body. Immutable.
class Load {
 public:
  virtual ~Load() = default;
  /// forces += F(t), 3 (n_nodes + n_inner) entries; only volume loads act on inner displacements.
  virtual void add(double t, std::span<double> forces) const = 0;
  /// Appends the part of the load that acts beyond a plane through the body. Surfaces and elements that the plane cuts
  /// are integrated up to it; the others by the rules of add(), so that force and moment are those of the nodal forces.
  /// Cost: a pass over the loaded domain.
  virtual void append_beyond(const Cut& cut, std::vector<PointForces>& parts) const = 0;
};

/// Pressure on faces [force/area], positive if it pushes on the body. @param pressure  of x, y, z, t
std::unique_ptr<Load> pressure_load(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces, Function pressure);
/// Force per area in fixed directions. @param traction  x, y, z components, functions of x, y, z, t
std::unique_ptr<Load> traction_load(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces,
                                    std::array<Function, 3> traction);
/// Axial force on the cross-section of a body in generalised plane strain. @param force  of t
std::unique_ptr<Load> axial_load(const mesh::Mesh& mesh, Function force);
/// Force at a node. @param force  three functions of t (x, y, z are those of the node)
std::unique_ptr<Load> point_load(const mesh::Mesh& mesh, std::int64_t node, std::array<Function, 3> force);
/// Forces at nodes, a fixed vector each, times a function of t.
std::unique_ptr<Load> nodal_load(std::vector<std::int64_t> nodes, std::vector<Vector3> forces, Function factor);
/// Force per volume. @param body  must outlive the load @param force_density  three functions of x, y, z, t
std::unique_ptr<Load> volume_load(const Discretization& body, std::array<Function, 3> force_density);
/// Centrifugal force density * omega^2 * (distance vector from the axis). @param body  must outlive the load
/// @param axis  direction, of any length @param origin  a point on the axis
/// @param angular_velocity  of t [rad/time] @param density  [mass/volume], of x, y, z, t
/// @throws ModelError if the axis is (0, 0, 0)
std::unique_ptr<Load> centrifugal_load(const Discretization& body, const Vector3& axis, const Vector3& origin,
                                       Function angular_velocity, Function density);

/// Unit outward normals at nodes of faces: area-weighted means over the adjacent faces, each with its normal at the
/// node.
/// @returns one per node, in the order of `nodes`
/// @throws ModelError if a node lies on none of the faces, or the normals of its faces cancel
std::vector<Vector3> nodal_normals(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces,
                                   const std::vector<std::int64_t>& nodes);

}  // namespace creepcontact::mechanics
