#include "creepcontact/results/contact_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "creepcontact/base/index.hpp"

namespace creepcontact::results {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Multipliers are linear on triangles and bilinear on quadrilaterals: means of corners at the nodes between them.
void fill_between_corners(const mesh::Face& face, std::vector<double>& values) {
  const std::size_t corners = mesh::n_corners(face.type);
  const auto value = [&](std::size_t k) -> double& { return values[face.nodes[k]]; };
  for (std::size_t k = corners; k < std::min(2 * corners, face.nodes.size()); ++k)
    value(k) = 0.5 * (value(k - corners) + value((k - corners + 1) % corners));
  if (face.type == mesh::CellType::quad9) value(8) = 0.25 * (value(0) + value(1) + value(2) + value(3));
}

}  // namespace

ContactSurfaces::ContactSurfaces(const creep::Assembly& assembly) : assembly_(assembly) {
  const std::vector<contact::Pair>& pairs = assembly.pairs();
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (pairs[p].ties_nodes()) continue;
    Surface surface{p, {}, {}};
    surface.faces = mesh::boundary_faces(body(surface), pairs[p].slave_surface);
    for (const mesh::Face& face : surface.faces)
      surface.nodes.insert(surface.nodes.end(), face.nodes.begin(), face.nodes.end());
    std::ranges::sort(surface.nodes);
    surface.nodes.erase(std::unique(surface.nodes.begin(), surface.nodes.end()), surface.nodes.end());
    for (mesh::Face& face : surface.faces)
      for (std::int64_t& node : face.nodes)
        node = std::ranges::lower_bound(surface.nodes, node) - surface.nodes.begin();
    surfaces_.push_back(std::move(surface));
  }
}

const contact::Pair& ContactSurfaces::pair(const Surface& surface) const {
  return assembly_.pairs()[surface.pair];
}

const mesh::Mesh& ContactSurfaces::body(const Surface& surface) const {
  return assembly_.bodies()[pair(surface).slave_body].mesh();
}

ContactSurfaces::Values ContactSurfaces::values(const Surface& surface, const creep::Equilibrium& at) const {
  const contact::Pair& contact = pair(surface);
  const bool tied = contact.coupling.type == contact::ContactType::tied;
  Values result{std::vector<double>(surface.nodes.size()), std::vector<double>(surface.nodes.size(), unknown)};
  for (std::size_t i = 0; i < contact.coupling.nodes.size(); ++i) {
    const contact::MultiplierNode& node = contact.coupling.nodes[i];
    const std::size_t k = std::ranges::lower_bound(surface.nodes, node.node) - surface.nodes.begin();
    const Index row = contact.first_row + (tied ? 3 * i : i);
    const double pressure = tied ? node.normal.dot(at.contact.multiplier.segment<3>(row)) : at.contact.multiplier[row];
    const double gap = tied ? 0.0 : at.gaps[row] / contact.coupling.area[i];
    // At a crease a node has several multipliers; the one that presses most is shown.
    if (!std::isnan(result.gap[k]) && std::abs(pressure) <= std::abs(result.pressure[k])) continue;
    result.pressure[k] = pressure;
    result.gap[k] = gap;
  }
  for (const mesh::Face& face : surface.faces) {
    fill_between_corners(face, result.pressure);
    fill_between_corners(face, result.gap);
  }
  return result;
}

io::FieldMesh ContactSurfaces::mesh() const {
  io::FieldMesh result;
  io::TextArray names{"contacts", {}};
  for (const Surface& surface : surfaces_) {
    const std::int64_t first = result.points.size();
    for (const std::int64_t node : surface.nodes) result.points.push_back(body(surface).nodes[node]);
    for (const mesh::Face& face : surface.faces) {
      if (result.blocks.empty() || result.blocks.back().type != face.type) result.blocks.push_back({face.type, {}});
      for (const std::int64_t node : face.nodes) result.blocks.back().connectivity.push_back(first + node);
    }
    names.values.push_back(pair(surface).name);
  }
  result.texts.push_back(std::move(names));
  return result;
}

std::vector<io::FieldData> ContactSurfaces::point_arrays(const creep::Equilibrium& at) const {
  io::FieldData displacement{"displacement", 3, {}}, pressure{"contact_pressure", 1, {}}, gap{"gap", 1, {}};
  for (const Surface& surface : surfaces_) {
    const std::vector<double>& moved = at.bodies[pair(surface).slave_body].displacement;
    for (const std::int64_t node : surface.nodes)
      displacement.values.insert(displacement.values.end(), moved.begin() + 3 * node, moved.begin() + 3 * node + 3);
    const Values on_surface = values(surface, at);
    pressure.values.insert(pressure.values.end(), on_surface.pressure.begin(), on_surface.pressure.end());
    gap.values.insert(gap.values.end(), on_surface.gap.begin(), on_surface.gap.end());
  }
  return {displacement, pressure, gap};
}

std::vector<io::FieldData> ContactSurfaces::cell_arrays() const {
  io::FieldData number{"contact", 1, {}};
  for (const Surface& surface : surfaces_)
    number.values.insert(number.values.end(), surface.faces.size(), static_cast<double>(surface.pair));
  return {number};
}

std::vector<io::FieldData> ContactSurfaces::on_bodies(const creep::Equilibrium& at) const {
  std::vector<std::size_t> first_node;
  std::size_t count = 0;
  for (const mechanics::Body& body : assembly_.bodies()) {
    first_node.push_back(count);
    count += body.mesh().n_cell_nodes();
  }
  io::FieldData pressure{"contact_pressure", 1, std::vector<double>(count)}, gap{"gap", 1, std::vector<double>(count)};
  std::vector<bool> known(count);
  for (const Surface& surface : surfaces_) {
    const Values on_surface = values(surface, at);
    for (std::size_t i = 0; i < surface.nodes.size(); ++i) {
      const std::size_t node = first_node[pair(surface).slave_body] + static_cast<std::size_t>(surface.nodes[i]);
      if (std::isnan(on_surface.gap[i]) && on_surface.pressure[i] == 0) continue;
      if (known[node] && std::abs(on_surface.pressure[i]) <= std::abs(pressure.values[node])) continue;
      known[node] = true;
      pressure.values[node] = on_surface.pressure[i];
      gap.values[node] = std::isnan(on_surface.gap[i]) ? 0.0 : on_surface.gap[i];
    }
  }
  return {pressure, gap};
}

}  // namespace creepcontact::results
