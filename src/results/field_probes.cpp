#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "face_points.hpp"
#include "local_fit.hpp"
#include "point_location.hpp"
#include "probe_kinds.hpp"
#include "probe_part.hpp"
#include "probe_quantity.hpp"

namespace creepcontact::results {
namespace {

/// True for nodal variables, which need no smoothed fields.
bool is_nodal(const ProbeQuantity& quantity) {
  return quantity.variable().is<AtNodes>();
}

/// Displacement interpolated in the element, the other fields fitted to the integration points around.
class PointProbe final : public Probe {
 public:
  /// @param rank  the member of the team that has the element; the location is not read on the others
  PointProbe(std::size_t body, int rank, std::optional<PointLocation> location, const creep::Assembly& assembly,
             ProbeQuantity quantity)
      : body_(body), rank_(rank), quantity_(std::move(quantity)) {
    if (rank != assembly.team().rank()) return;
    location_ = std::move(location.value());
    const mechanics::Body& owner = assembly.bodies()[body];
    points_ = local_fit(owner.discretization(), owner.mesh(), elements_at(owner.discretization(), location_),
                        location_.position);
  }

  double value(Snapshot& snapshot) const override {
    const Team& team = snapshot.assembly().team();
    double value = team.rank() == rank_ ? own_value(snapshot) : 0;
    team.broadcast({&value, 1}, rank_);
    return value;
  }

 private:
  double own_value(Snapshot& snapshot) const {
    Sample sample;
    for (std::size_t i = 0; i < location_.nodes.size(); ++i)
      sample.displacement += location_.weights[i] * snapshot.moved_node(body_, location_.nodes[i]).displacement;
    sample.position = location_.position;
    if (is_nodal(quantity_)) return quantity_(sample);
    const BodyFields& fields = snapshot.fields(body_);
    for (const auto& [point, weight] : points_) {
      const Sample at_point = fields.at_point(point);
      sample.stress += weight * at_point.stress;
      sample.strain += weight * at_point.strain;
      sample.creep_strain += weight * at_point.creep_strain;
      sample.temperature += weight * at_point.temperature;
      sample.heat_flux += weight * at_point.heat_flux;
      sample.state.resize(at_point.state.size());
      for (std::size_t k = 0; k < at_point.state.size(); ++k) sample.state[k] += weight * at_point.state[k];
    }
    if (const std::vector<double>& computed = fields.computed_temperature(); !computed.empty()) {
      sample.temperature = 0;
      for (std::size_t i = 0; i < location_.nodes.size(); ++i)
        sample.temperature += location_.weights[i] * computed[static_cast<std::size_t>(location_.nodes[i])];
    }
    return quantity_(sample);
  }

  std::size_t body_;
  int rank_;
  PointLocation location_;
  std::vector<std::pair<std::size_t, double>> points_;
  ProbeQuantity quantity_;
};

/// Nodes with weights: areas on a surface, 1 on curves and points.
class NodesProbe final : public Probe {
 public:
  struct Part {
    std::size_t body;
    std::vector<std::pair<std::size_t, double>> nodes;
  };
  NodesProbe(std::vector<Part> parts, ProbeQuantity quantity, config::Reduce reduce)
      : parts_(std::move(parts)), quantity_(std::move(quantity)), reduce_(reduce) {}

  double value(Snapshot& snapshot) const override {
    Reduction reduction(reduce_);
    const bool at_nodes = is_nodal(quantity_);
    for (const Part& part : parts_)
      for (const auto& [node, weight] : part.nodes)
        reduction.add(
            quantity_(at_nodes ? snapshot.moved_node(part.body, node) : snapshot.fields(part.body).at_node(node)),
            weight);
    return reduction.result(snapshot.assembly().team());
  }

 private:
  std::vector<Part> parts_;
  ProbeQuantity quantity_;
  config::Reduce reduce_;
};

/// Integration points with their volumes, or nodes.
class VolumeProbe final : public Probe {
 public:
  /// @param places  numbers of the points (displacements: nodes) with their weights
  VolumeProbe(std::size_t body, std::vector<std::pair<std::size_t, double>> places, ProbeQuantity quantity,
              config::Reduce reduce)
      : body_(body), places_(std::move(places)), quantity_(std::move(quantity)), reduce_(reduce) {}

  double value(Snapshot& snapshot) const override {
    Reduction reduction(reduce_);
    const bool at_nodes = is_nodal(quantity_);
    for (const auto& [place, weight] : places_)
      reduction.add(quantity_(at_nodes ? snapshot.moved_node(body_, place) : snapshot.fields(body_).at_point(place)),
                    weight);
    return reduction.result(snapshot.assembly().team());
  }

 private:
  std::size_t body_;
  std::vector<std::pair<std::size_t, double>> places_;
  ProbeQuantity quantity_;
  config::Reduce reduce_;
};

/// Share of every node in the area of the faces, so that sums over nodes are area integrals of the interpolated field.
/// On the edges of sections it is the area over the depth.
/// @param part  of the faces: where it holds at the points of their rule
std::vector<std::pair<std::size_t, double>> nodal_areas(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces,
                                                        const ProbePart& part) {
  std::map<std::size_t, double> areas;
  for (const mesh::Face& face : faces)
    for (const FacePoint& point : face_points(mesh, face)) {
      if (!part.holds(point.position)) continue;
      for (std::size_t i = 0; i < face.nodes.size(); ++i) areas[face.nodes[i]] += point.area * point.shape[i];
    }
  return {areas.begin(), areas.end()};
}

constexpr double surface_tolerance = 1e-3;  // of an element's size: meshes only approximate curved surfaces

bool lies_in(const PointLocation& location, const mesh::Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const std::int64_t node : location.nodes) box.extend(mesh.nodes[node]);
  return location.distance <= surface_tolerance * box.diagonal().norm();
}

std::unique_ptr<Probe> point_probe(const config::Probe& probe, const model::Model& model,
                                   std::span<const PointLocator> locators) {
  const Vector3 at((*probe.at)[0], (*probe.at)[1], (*probe.at)[2]);
  const std::size_t n_bodies = model.bodies().size();
  std::vector<std::optional<PointLocation>> found(n_bodies);
  std::vector<double> distance(n_bodies, std::numeric_limits<double>::infinity()), lies_there(n_bodies, 0.0);
  for (std::size_t b = 0; b < n_bodies; ++b) {
    if (probe.body.given() && model::find_body(model.bodies(), probe.body.name) != b) continue;
    found[b] = locators[b].locate(at);
    if (!found[b]) continue;
    distance[b] = found[b]->distance;
    lies_there[b] = lies_in(*found[b], model.bodies()[b].mesh()) ? 1 : 0;
  }
  const Team& team = model.assembly.team();
  const std::vector<double> own_distance = distance;
  team.min(distance);
  team.max(lies_there);
  std::vector<std::size_t> holders;
  for (std::size_t b = 0; b < n_bodies; ++b)
    if (lies_there[b] > 0) holders.push_back(b);
  if (holders.size() > 1)
    throw ModelError(
        fmt::format("the point ({}, {}, {}) lies in body '{}' and in body '{}'; say which one is meant: body = \"{}\"",
                    at.x(), at.y(), at.z(), model.bodies()[holders[0]].name(), model.bodies()[holders[1]].name(),
                    model.bodies()[holders[0]].name()));
  const std::size_t best = std::ranges::min_element(distance) - distance.begin();
  if (std::isinf(distance[best]))
    throw ModelError(fmt::format("the point ({}, {}, {}) lies outside {}", at.x(), at.y(), at.z(),
                                 probe.body.given() ? "body '" + probe.body.name + "'" : "all bodies"));
  return std::make_unique<PointProbe>(best, team.rank_of_max(-own_distance[best]), found[best], model.assembly,
                                      ProbeQuantity(probe));
}

std::unique_ptr<Probe> group_probe(const config::Probe& probe, const model::Model& model) {
  const ProbePart where(probe);
  const bool is_extreme = probe.reduce == config::Reduce::max || probe.reduce == config::Reduce::min;
  std::vector<NodesProbe::Part> parts;
  double found = 0;
  for (const std::size_t b : probe_bodies(probe, model)) {
    const mesh::Mesh& mesh = model.bodies()[b].mesh();
    NodesProbe::Part part{b, {}};
    const bool is_surface = mesh.group(probe.on.name).dimension == mesh.section.dimension() - 1;
    // Means and integrals take the part of each face, extremes its nodes.
    if (is_surface && (where.is_whole() || !is_extreme))
      part.nodes = nodal_areas(mesh, mesh::boundary_faces(mesh, probe.on.name), where);
    else
      for (const std::int64_t node : mesh::group_nodes(mesh, probe.on.name))
        if (where.holds(mesh.nodes[node])) part.nodes.emplace_back(node, 1.0);
    if (!part.nodes.empty()) found = 1;
    parts.push_back(std::move(part));
  }
  if (!where.is_whole()) where.require(model.assembly.team().max(found) > 0, fmt::format("'{}'", probe.on.name));
  return std::make_unique<NodesProbe>(std::move(parts), ProbeQuantity(probe), probe.reduce);
}

std::unique_ptr<Probe> body_probe(const config::Probe& probe, const model::Model& model) {
  const ProbePart where(probe);
  const ProbeQuantity quantity(probe);
  const std::size_t b = model::find_body(model.bodies(), probe.body.name);
  const mechanics::Body& body = model.bodies()[b];
  const mechanics::Discretization& discretization = body.discretization();
  std::vector<std::pair<std::size_t, double>> places;
  if (is_nodal(quantity)) {
    for (std::size_t i = 0; i < body.mesh().n_cell_nodes(); ++i)
      if (where.holds(body.mesh().nodes[i])) places.emplace_back(i, 1.0);
  } else {
    for (std::size_t p = 0; p < discretization.n_points(); ++p)
      if (where.holds(discretization.point_coordinates()[p])) places.emplace_back(p, discretization.weights()[p]);
  }
  if (!where.is_whole())
    where.require(model.assembly.team().max(places.empty() ? 0 : 1) > 0, fmt::format("body '{}'", body.name()));
  return std::make_unique<VolumeProbe>(b, std::move(places), quantity, probe.reduce);
}

std::unique_ptr<Probe> field_probe(const ProbeRequest& request) {
  if (request.probe.at) return point_probe(request.probe, request.model, request.locators);
  if (request.probe.on.given()) return group_probe(request.probe, request.model);
  return body_probe(request.probe, request.model);
}

}  // namespace

std::unique_ptr<Probe> make_probe(const AtNodes& /*nodes*/, const ProbeRequest& request) {
  return field_probe(request);
}

std::unique_ptr<Probe> make_probe(const AtPoints& /*points*/, const ProbeRequest& request) {
  return field_probe(request);
}

}  // namespace creepcontact::results
