#include "model_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "creepcontact/base/error.hpp"
#include "creepcontact/material/creep_fatigue.hpp"
#include "creepcontact/material/registry.hpp"
#include "creepcontact/mesh/group_kind.hpp"
#include "model_links.hpp"
#include "shared_nodes.hpp"

namespace creepcontact::model {

namespace {

std::shared_ptr<const material::LifeFraction> make_life_fraction(const config::Rupture& from) {
  double alpha = 0;
  if (from.stress_measure == config::StressMeasure::principal) alpha = 1;
  if (from.stress_measure == config::StressMeasure::mixed) alpha = from.alpha.value();
  return std::make_shared<material::LifeFraction>(rupture_data(from), alpha);
}

std::shared_ptr<const material::CreepLaw> make_creep_fatigue(const config::Fatigue& from,
                                                             std::shared_ptr<const material::LifeFraction> creep) {
  auto curve = from.cycles_to_failure ? material::fatigue_expression(*from.cycles_to_failure)
                                      : material::fatigue_table(from.strain_range, from.cycles);
  std::vector<material::InteractionDiagram::Point> points;
  for (const std::vector<double>& point : from.interaction) points.push_back({point.at(0), point.at(1)});
  return std::make_shared<material::CreepFatigue>(std::move(curve), material::InteractionDiagram(std::move(points)),
                                                  std::move(creep));
}

}  // namespace

std::shared_ptr<const material::RuptureData> rupture_data(const config::Rupture& from) {
  return from.rupture_time ? material::rupture_expression(*from.rupture_time)
                           : material::larson_miller({.constant = from.larson_miller_constant,
                                                      .stress = from.stress,
                                                      .parameter = from.parameter,
                                                      .absolute_zero = from.absolute_zero,
                                                      .time_unit = from.time_unit});
}

std::shared_ptr<const material::Plasticity> make_plasticity(const config::Plasticity& from) {
  std::vector<material::BackStress> back;
  for (const config::KinematicHardening& one : from.kinematic) back.push_back({one.C, one.gamma});
  if (from.curve.empty())
    return std::make_shared<material::Plasticity>(*from.yield_stress, from.hardening_modulus, std::move(back));
  std::vector<material::YieldCurve> curves;
  for (const config::PlasticCurve& curve : from.curve)
    curves.push_back({curve.T.value_or(0), curve.plastic_strain, curve.stress});
  return std::make_shared<material::Plasticity>(std::move(curves), std::move(back));
}

std::vector<std::shared_ptr<const material::CreepLaw>> make_creep_laws(
    const std::vector<config::CreepMechanism>& from) {
  std::vector<std::shared_ptr<const material::CreepLaw>> laws;
  for (const config::CreepMechanism& mechanism : from) {
    std::map<std::string, std::vector<Function>> values;
    for (const config::CreepParameter& parameter : mechanism.parameters) values[parameter.key] = parameter.values;
    laws.push_back(material::find_creep_law(mechanism.law)->make_by_key(values));
  }
  return laws;
}

material::Material make_material(const config::Material& from) {
  material::Material result;
  result.name = from.name;
  if (from.orthotropic) {
    const config::Orthotropic& given = *from.orthotropic;
    result.orthotropy = material::Orthotropy{given.young_moduli, given.poisson_ratios, given.shear_moduli};
    result.young_modulus = result.orthotropy->average_young_modulus();
    result.poisson_ratio = result.orthotropy->average_poisson_ratio();
  } else {
    result.young_modulus = from.young_modulus;
    result.poisson_ratio = from.poisson_ratio;
  }
  if (from.hill) {
    const auto &normal = from.hill->normal, &shear = from.hill->shear;
    result.hill = material::HillRatios{{normal[0], normal[1], normal[2], shear[0], shear[1], shear[2]}};
    material::hill_transformation(*result.hill);  // throws where it is not possible
  }
  const std::vector<Function>& alpha = from.thermal_expansion;
  if (alpha.size() == 3)
    result.thermal_expansion = material::ThermalExpansion({alpha[0], alpha[1], alpha[2]});
  else
    result.thermal_expansion = alpha.front();
  result.reference_temperature = from.reference_temperature.value_or(0);
  result.creep = make_creep_laws(from.creep);
  result.yield_strength = from.yield_strength;
  if (from.plasticity) result.plasticity = make_plasticity(*from.plasticity);
  const auto life = from.rupture ? make_life_fraction(*from.rupture) : nullptr;
  if (from.fatigue)
    result.creep.push_back(make_creep_fatigue(*from.fatigue, life));
  else if (life)
    result.creep.push_back(life);
  return result;
}

namespace {

/// matrix (x - origin) as functions of x, y, z.
std::array<Function, 3> linear_functions(const Matrix3& matrix, const Vector3& origin) {
  std::vector<Function> place;
  for (const char* coordinate : {"x", "y", "z"}) place.push_back(Function::expression(coordinate, {coordinate}));
  std::array<Function, 3> result;
  for (Index i = 0; i < 3; ++i) {
    const Eigen::RowVector3d row = matrix.row(i);
    const double constant = row * origin;
    result[i] =
        Function::composed(fmt::format("({:.17g}, {:.17g}, {:.17g}).x - {:.17g}", row[0], row[1], row[2], constant),
                           place, [row, constant](const std::vector<double>& x) {
                             return row[0] * x[0] + row[1] * x[1] + row[2] * x[2] - constant;
                           });
  }
  return result;
}

mechanics::MaterialAxes cylindrical_axes(const config::CylindricalAxes& given) {
  const Vector3 axis = Vector3::Map(given.axis.data()).normalized(), origin = Vector3::Map(given.origin.data());
  const Matrix3 radial = Matrix3::Identity() - axis * axis.transpose();
  Matrix3 around;  // axis x (x - origin)
  for (Index i = 0; i < 3; ++i) around.col(i) = axis.cross(Vector3::Unit(i));
  return {linear_functions(radial, origin), linear_functions(around, origin)};
}

}  // namespace

std::optional<mechanics::MaterialAxes> material_axes(const config::Body& body) {
  if (!body.material_axes) return std::nullopt;
  if (body.material_axes->cylindrical) return cylindrical_axes(*body.material_axes->cylindrical);
  return mechanics::MaterialAxes{body.material_axes->first, body.material_axes->second};
}

std::size_t body_index(const config::Config& config, const std::string& name) {
  const auto found =
      std::find_if(config.bodies.begin(), config.bodies.end(), [&](const auto& body) { return body.name == name; });
  return found - config.bodies.begin();
}

std::vector<std::size_t> bodies_on(const config::Config& config, const mesh::Mesh& whole, const BodyMeshes& meshes,
                                   const std::string& group, const config::Reference& body, int dimension) {
  whole.group(group, dimension);  // names the groups that exist if there is none of this name
  std::vector<std::size_t> result;
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    if (body.given() && b != body_index(config, body.name)) continue;
    const auto found = meshes[b].groups.find(group);
    if (found != meshes[b].groups.end() && !found->second.cells.empty()) result.push_back(b);
  }
  if (result.empty())
    throw ModelError(body.given() ? fmt::format("group '{}' is not on body '{}'", group, body.name)
                                  : fmt::format("group '{}' is on none of the bodies", group));
  return result;
}

std::vector<NodeOfBody> nodes_numbered(std::span<const mechanics::Body> bodies, std::int64_t number) {
  std::vector<NodeOfBody> result;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const std::vector<std::int64_t>& numbers = bodies[b].mesh().node_numbers;  // ascending
    const auto found = std::ranges::lower_bound(numbers, number);
    if (found != numbers.end() && *found == number) result.push_back({b, found - numbers.begin()});
  }
  return result;
}

namespace {

/// Faces that no element has: where bodies touch, a mesher may have merged nodes and left the faces of one of them
/// behind.
void require_no_orphans(const mesh::Mesh& whole, const std::string& surface) {
  const auto found = whole.groups.find(surface);
  if (found == whole.groups.end() || found->second.dimension != whole.section.dimension() - 1) return;
  if (const std::size_t n = mesh::n_orphan_faces(whole, surface))
    throw ModelError(
        fmt::format("{} of the {} cells of {} '{}' belong to no element of a body; the mesher may have merged nodes "
                    "of bodies that touch: mesh the bodies a small distance apart and set the gap of the contact",
                    n, found->second.cells.size(), mesh::group_kind(found->second.dimension), surface));
}

}  // namespace

void check_groups(const config::Config& config, const mesh::Mesh& whole, const BodyMeshes& meshes,
                  ErrorCollector& errors) {
  for (const config::Support& support : config.supports)
    errors.collect(support.on.location, [&] { require_no_orphans(whole, support.on.name); });
  for (const config::Load& load : config.loads)
    if (load.on.given())
      errors.collect(load.on.location, [&] {
        bodies_on(config, whole, meshes, load.on.name, load.body, whole.section.dimension() - 1);
        require_no_orphans(whole, load.on.name);
      });
  for (const config::Contact& contact : config.contacts)
    for (const config::Reference& surface : contact.between)
      errors.collect(surface.location, [&] {
        bodies_on(config, whole, meshes, surface.name, {}, whole.section.dimension() - 1);
        require_no_orphans(whole, surface.name);
      });
}

namespace {

/// Unit vectors away from the axis.
std::vector<Vector3> radial_directions(const config::Support& support, const mesh::Mesh& body,
                                       const std::vector<std::int64_t>& nodes) {
  constexpr double on_axis = 1e-9;  // of the farthest node
  const Vector3 axis = vector(support.axis).normalized();
  std::vector<Vector3> result;
  result.reserve(nodes.size());
  double farthest = 0;
  for (const std::int64_t node : nodes) {
    const Vector3 arm = body.nodes[node] - vector(support.origin);
    result.emplace_back(arm - arm.dot(axis) * axis);
    farthest = std::max(farthest, result.back().norm());
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (result[i].norm() <= on_axis * farthest)
      throw ModelError(
          fmt::format("the node ({:.6g}, {:.6g}, {:.6g}) of '{}' is on the axis, where there is no radial and no "
                      "tangential direction; take it out of the group",
                      body.nodes[nodes[i]][0], body.nodes[nodes[i]][1], body.nodes[nodes[i]][2], support.on.name));
    result[i].normalize();
  }
  return result;
}

/// Components about an axis.
void add_cylindrical(const config::Support& support, const mesh::Mesh& body, const std::vector<std::int64_t>& nodes,
                     std::vector<mechanics::Support>& to) {
  const auto& [radial, tangential, axial] = support.cylindrical;
  const Vector3 axis = vector(support.axis).normalized();
  if (axial) to.push_back({support.on.name, nodes, {axis}, *axial});
  if (!radial && !tangential) return;
  std::vector<Vector3> directions = radial_directions(support, body, nodes);
  if (radial) to.push_back({support.on.name, nodes, directions, *radial});
  if (!tangential) return;
  for (Vector3& direction : directions) direction = axis.cross(direction);
  to.push_back({support.on.name, nodes, std::move(directions), *tangential});
}

}  // namespace

std::vector<mechanics::Support> make_supports(const config::Support& support, const mesh::Mesh& body) {
  std::vector<mechanics::Support> result;
  const std::vector<std::int64_t> nodes = mesh::group_nodes(body, support.on.name);
  for (int k = 0; k < 3; ++k)
    if (const auto& value = support.displacement[k])
      result.push_back({support.on.name, nodes, {Vector3(Vector3::Unit(k))}, *value});
  if (support.normal) {
    const int boundary = body.section.dimension() - 1;
    if (body.group(support.on.name).dimension != boundary)
      throw ModelError(fmt::format("group '{}' is not a {}: it has no normal; give x{}", support.on.name,
                                   mesh::group_kind(boundary), boundary == 2 ? ", y or z" : " or y"));
    const std::vector<mesh::Face> faces = mesh::boundary_faces(body, support.on.name);
    result.push_back({support.on.name, nodes, mechanics::nodal_normals(body, faces, nodes), *support.normal});
  }
  add_cylindrical(support, body, nodes, result);
  if (support.along) result.push_back({support.on.name, nodes, {vector(*support.direction)}, *support.along});
  return result;
}

namespace {

/// Whether the surfaces are drawn at the thickness of the gasket, not touching.
/// @throws ModelError if neither, where the gap is not measured
bool has_room_for(const contact::GasketKind& gasket, const config::Contact& contact,
                  const contact::MortarCoupling& coupling) {
  constexpr double same = 0.05;  // of the thickness
  const double thickness = gasket.law.thickness();
  double distance = 0;
  for (const double one : coupling.gap_distances) distance += one / static_cast<double>(coupling.gap_distances.size());
  if (contact.geometric_gap || !contact.gap.is_zero() || std::abs(distance) <= same * thickness ||
      std::abs(distance - thickness) <= same * thickness)
    return distance > thickness / 2;
  throw ModelError(fmt::format(
      "gasket '{}' is {:.6g} thick, but the surfaces '{}' and '{}' are drawn {:.6g} apart; draw them at its thickness "
      "or touching, or say by 'gap' how far they are from the uncompressed gasket",
      gasket.name, thickness, contact.between[0].name, contact.between[1].name, distance));
}

}  // namespace

contact::Pair make_pair(const config::Contact& contact, const config::Config& config, const Bodies& bodies,
                        const std::optional<mechanics::TemperatureField>& temperature, const GasketKinds& gaskets,
                        const SharedCouplings& couplings, std::span<const mechanics::RigidMotion> sliding) {
  const std::array<std::size_t, 2> body = contact_bodies(
      contact, config, {bodies_with(bodies, contact.between[0].name), bodies_with(bodies, contact.between[1].name)});
  std::array<contact::Surface, 2> surfaces;
  for (std::size_t side = 0; side < 2; ++side) {
    const mechanics::Body& owner = bodies[body[side]];
    surfaces[side].name = contact.between[side].name;
    surfaces[side].mesh = &owner.mesh();
    surfaces[side].constraints = &owner.constraints();
    surfaces[side].faces = mesh::boundary_faces(owner.mesh(), contact.between[side].name);
    surfaces[side].sector = sector(config);
    surfaces[side].young_modulus = owner.material().young_modulus({.T = owner.material().reference_temperature});
  }
  const bool first_is_slave =
      contact.slave >= 0 ? contact.slave == 0 : contact::first_is_better_slave(surfaces[0], surfaces[1]);
  const std::size_t slave = first_is_slave ? 0 : 1;
  const std::size_t master = 1 - slave;

  contact::Pair pair;
  pair.name = contact.name;
  pair.slave_surface = surfaces[slave].name;
  pair.master_surface = surfaces[master].name;
  pair.slave_body = body[slave];
  pair.master_body = body[master];
  pair.coupling = couplings.of(contact, slave, sliding, [&] {
    return contact.type == settings::ContactType::tied
               ? contact::tied_coupling(surfaces[slave], surfaces[master])
               : contact::mortar_coupling(surfaces[slave], surfaces[master], contact.type, sliding,
                                          !contact.friction.is_zero());
  });
  pair.gap = contact.gap;
  if (contact.preload) pair.preload = {contact.preload->force, contact.preload->time};
  pair.geometric_gap = contact.geometric_gap;
  const auto here = temperature ? std::optional(temperature->on(*surfaces[slave].mesh)) : std::nullopt;
  std::vector<Vector3> positions;
  for (const contact::MultiplierNode& node : pair.coupling.nodes)
    positions.push_back(surfaces[slave].mesh->nodes[node.node]);
  if (contact.gasket.given()) {
    const auto& kind = gaskets.at(contact.gasket.name);
    if (has_room_for(*kind, contact, pair.coupling))
      pair.coupling.geometric_gap -= pair.coupling.on_rows(
          kind->law.thickness() * Eigen::Map<const Eigen::VectorXd>(pair.coupling.area.data(), std::ssize(positions)));
    pair.gasket = std::make_shared<const contact::Gasket>(kind, here, positions);
  }
  if (pair.coupling.has_friction()) {
    pair.friction = {contact.friction, here, std::move(positions)};
    pair.friction.at(0);  // an error here names the contact's place in the configuration
  }
  return pair;
}

}  // namespace creepcontact::model
