#include "creepcontact/results/contact_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "creepcontact/base/index.hpp"
#include "creepcontact/mesh/cell_faces.hpp"
#include "creepcontact/results/quantities.hpp"

namespace creepcontact::results {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Mean values; the gap is unknown if one of them is.
ContactValues mean(std::initializer_list<ContactValues> values) {
  ContactValues sum;
  for (const ContactValues& value : values) {
    sum.pressure += value.pressure;
    sum.gap += value.gap;
    sum.traction += value.traction;
    sum.shear += value.shear;
    sum.slip += value.slip;
    sum.closure += value.closure;
    sum.largest_closure += value.largest_closure;
    sum.creep_closure += value.creep_closure;
    sum.temperature_jump += value.temperature_jump;
    sum.conductance += value.conductance;
    sum.status = std::max(sum.status, value.status);
  }
  const auto n = static_cast<double>(values.size());
  for (double ContactValues::*const part :
       {&ContactValues::pressure, &ContactValues::gap, &ContactValues::shear, &ContactValues::slip,
        &ContactValues::closure, &ContactValues::largest_closure, &ContactValues::creep_closure,
        &ContactValues::temperature_jump, &ContactValues::conductance})
    sum.*part /= n;
  sum.traction /= n;
  return sum;
}

/// Multipliers are linear on triangles and bilinear on quadrilaterals: means of corners at the nodes between them.
void fill_between_corners(const mesh::Face& face, std::vector<ContactValues>& values) {
  const std::size_t corners = mesh::n_corners(face.type);
  const auto value = [&](std::size_t k) -> ContactValues& { return values[face.nodes[k]]; };
  for (std::size_t k = corners; k < std::min(2 * corners, face.nodes.size()); ++k)
    value(k) = mean({value(k - corners), value((k - corners + 1) % corners)});
  if (face.type == mesh::CellType::quad9) value(8) = mean({value(0), value(1), value(2), value(3)});
}

bool has_friction(const creep::Equilibrium& at) {
  return at.friction.slip.size() > 0;
}

bool is_in(AtMultipliers::In models, const creep::Equilibrium& at, bool has_heat) {
  if (models == AtMultipliers::In::with_heat) return has_heat;
  if (models == AtMultipliers::In::with_friction) return has_friction(at);
  return models == AtMultipliers::In::all || at.largest_closure.size() > 0;
}

/// The output variables of contact surfaces that the files of this model have.
std::vector<const OutputVariable*> variables_of(const creep::Equilibrium& at, bool has_heat = false) {
  std::vector<const OutputVariable*> found;
  for (const OutputVariable& variable : output_variables()) {
    const auto* multipliers = std::get_if<AtMultipliers>(&variable.support);
    if (multipliers != nullptr && is_in(multipliers->models, at, has_heat)) found.push_back(&variable);
  }
  return found;
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

ContactSurfaces::Values ContactSurfaces::values(const Surface& surface, const creep::Equilibrium& at,
                                                std::span<const heat::NodeOfInterface> heat) const {
  const contact::Pair& contact = pair(surface);
  Values result(surface.nodes.size(), ContactValues{.gap = unknown});
  const auto show = [&](std::int64_t node, const ContactValues& here) {
    const std::size_t k = std::ranges::lower_bound(surface.nodes, node) - surface.nodes.begin();
    // A node at a crease has several multipliers; the one with the largest pressure is shown.
    if (!std::isnan(result[k].gap) && std::abs(here.pressure) <= std::abs(result[k].pressure)) return;
    result[k] = here;
  };
  const PairValues values(contact, at, heat);
  for (std::size_t i = 0; i < contact.coupling.nodes.size(); ++i) show(contact.coupling.nodes[i].node, values[i]);
  for (const contact::MortarCoupling::Image& image : contact.coupling.images) {
    ContactValues here = values[image.of];
    here.traction = contact.coupling.sector->rotation * here.traction;
    show(image.at.node, here);
  }
  for (const mesh::Face& face : surface.faces) fill_between_corners(face, result);
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

std::vector<io::FieldData> ContactSurfaces::point_arrays(const creep::Equilibrium& at,
                                                         std::span<const heat::NodeOfInterface> heat) const {
  io::FieldData displacement{"displacement", 3, {}}, traction{"contact_traction", 3, {}};
  Values all;
  for (const Surface& surface : surfaces_) {
    const std::vector<double>& moved = at.bodies[pair(surface).slave_body].displacement;
    for (const std::int64_t node : surface.nodes)
      displacement.values.insert(displacement.values.end(), moved.begin() + 3 * node, moved.begin() + 3 * node + 3);
    for (const ContactValues& here : values(surface, at, heat)) {
      all.push_back(here);
      traction.values.insert(traction.values.end(), here.traction.begin(), here.traction.end());
    }
  }
  std::vector<io::FieldData> arrays{std::move(displacement)};
  bool has_traction = !has_friction(at);
  for (const OutputVariable* variable : variables_of(at, !heat.empty())) {
    const auto& multipliers = std::get<AtMultipliers>(variable->support);
    if (multipliers.models == AtMultipliers::In::with_friction && !std::exchange(has_traction, true))
      arrays.push_back(std::exchange(traction, {}));
    io::FieldData& array = arrays.emplace_back(io::FieldData{variable->name, 1, {}});
    for (const ContactValues& here : all) array.values.push_back(here.*multipliers.value);
  }
  return arrays;
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
  Values shown(count);
  std::vector<bool> known(count);
  for (const Surface& surface : surfaces_) {
    const Values on_surface = values(surface, at);
    for (std::size_t i = 0; i < surface.nodes.size(); ++i) {
      const std::size_t node = first_node[pair(surface).slave_body] + static_cast<std::size_t>(surface.nodes[i]);
      ContactValues here = on_surface[i];
      if (std::isnan(here.gap) && here.pressure == 0) continue;
      if (known[node] && std::abs(here.pressure) <= std::abs(shown[node].pressure)) continue;
      known[node] = true;
      if (std::isnan(here.gap)) here.gap = 0.0;
      shown[node] = here;
    }
  }
  std::vector<io::FieldData> arrays;
  for (const OutputVariable* variable : variables_of(at)) {
    const auto& multipliers = std::get<AtMultipliers>(variable->support);
    if (!multipliers.in_body_files) continue;
    io::FieldData& array = arrays.emplace_back(io::FieldData{variable->name, 1, {}});
    for (const ContactValues& here : shown) array.values.push_back(here.*multipliers.value);
  }
  return arrays;
}

}  // namespace creepcontact::results
