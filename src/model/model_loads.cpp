#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "creepcontact/base/error.hpp"
#include "creepcontact/mesh/axis.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {
namespace {

constexpr double nearest_node_tolerance = 1e-6;  // of the model size

/// @param nodes  ascending
bool lies_on_axis(const mesh::Mesh& mesh, const std::vector<std::int64_t>& nodes) {
  return std::ranges::includes(mesh::axis_nodes(mesh), nodes);
}

/// Adds one [[loads]] entry to the bodies it acts on, by kind.
struct LoadAdder {
  const config::Load& load;
  const config::Config& config;
  const mesh::Mesh& whole;
  const BodyMeshes& meshes;
  Bodies& bodies;

  std::vector<std::size_t> surface_bodies() const {
    if (whole.section.is_axisymmetric() && lies_on_axis(whole, mesh::group_nodes(whole, load.on.name)))
      throw ModelError(
          fmt::format("curve '{}' lies on the axis, where it has no area to load; remove the load", load.on.name));
    return bodies_on(config, whole, meshes, load.on.name, load.body, whole.section.dimension() - 1);
  }
  mechanics::Body& body() const { return bodies[body_index(config, load.body.name)]; }

  void operator()(const config::Pressure& pressure) const {
    for (const std::size_t b : surface_bodies())
      bodies[b].add_load(mechanics::pressure_load(
          bodies[b].mesh(), mesh::boundary_faces(bodies[b].mesh(), load.on.name), pressure.value));
  }
  void operator()(const config::Traction& traction) const {
    for (const std::size_t b : surface_bodies())
      bodies[b].add_load(mechanics::traction_load(
          bodies[b].mesh(), mesh::boundary_faces(bodies[b].mesh(), load.on.name), traction.value));
  }
  void operator()(const config::BodyForce& force) const {
    body().add_load(mechanics::volume_load(body().discretization(), force.value));
  }
  void operator()(const config::Rotation& rotation) const {
    body().add_load(mechanics::centrifugal_load(body().discretization(), vector(rotation.axis), vector(rotation.origin),
                                                rotation.angular_velocity, rotation.density));
  }
  /// The node with a number of the mesh file.
  NodeOfBody numbered(int number) const {
    std::vector<NodeOfBody> found = nodes_numbered(bodies, number);
    if (load.body.given())
      std::erase_if(found, [&](const NodeOfBody& at) { return at.body != body_index(config, load.body.name); });
    if (found.empty())
      throw ModelError(load.body.given()
                           ? fmt::format("body '{}' has no node {} of the mesh file", load.body.name, number)
                           : fmt::format("no body has the node {} of the mesh file", number));
    return found.front();
  }
  NodeOfBody nearest(const Vector3& at, std::optional<double> given_tolerance) const {
    Eigen::AlignedBox3d box;
    NodeOfBody nearest;
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const auto& nodes = bodies[b].mesh().nodes;
      const bool wanted = !load.body.given() || body_index(config, load.body.name) == b;
      for (std::size_t i = 0; i < bodies[b].mesh().n_cell_nodes(); ++i) {
        box.extend(nodes[i]);
        if (!wanted || (nodes[i] - at).norm() >= distance) continue;
        distance = (nodes[i] - at).norm();
        nearest = {b, static_cast<std::int64_t>(i)};
      }
    }
    const double tolerance = given_tolerance.value_or(nearest_node_tolerance * box.diagonal().norm());
    const Vector3& x = bodies[nearest.body].mesh().nodes[nearest.node];
    if (distance > tolerance)
      throw ModelError(
          fmt::format("no mesh node at ({}, {}, {}): the nearest is ({}, {}, {}) on body '{}', {:.3g} away; give its "
                      "coordinates, or a larger tolerance",
                      at.x(), at.y(), at.z(), x.x(), x.y(), x.z(), bodies[nearest.body].name(), distance));
    return nearest;
  }
  void operator()(const config::PointForce& force) const {
    const auto [b, node] = force.at ? nearest(vector(*force.at), force.tolerance) : numbered(force.node);
    const mesh::Mesh& mesh = bodies[b].mesh();
    if (mesh.section.is_axisymmetric() && !force.value[0].is_zero() && lies_on_axis(mesh, {node}))
      throw ModelError(fmt::format(
          "a radial force at ({:.6g}, {:.6g}, 0) on the axis: a ring of no radius carries none; give a force along y",
          mesh.nodes[node].x(), mesh.nodes[node].y()));
    bodies[b].add_load(mechanics::point_load(mesh, node, force.value));
  }
};

}  // namespace

void add_load(const config::Load& load, const config::Config& config, const mesh::Mesh& whole, const BodyMeshes& meshes,
              Bodies& bodies) {
  std::visit(LoadAdder{load, config, whole, meshes, bodies}, load.kind);
}

}  // namespace creepcontact::model
