#include "creepcontact/results/snapshot.hpp"

#include <algorithm>

namespace creepcontact::results {
namespace {

Tensor6 tensor_at(const std::vector<double>& values, std::size_t i) {
  return tensor::view(values, i);
}

constexpr bool is_tensor(PointField field) {
  using enum PointField;
  return field == stress || field == strain || field == creep_strain;
}
constexpr std::size_t number(PointField field) {
  return static_cast<std::size_t>(field);
}

}  // namespace

BodyFields::BodyFields(const mechanics::Body& body, const mechanics::BodyConditions& conditions,
                       const creep::BodyState& state, mechanics::CreepStrainView creep, PointMeasures measures)
    : body_(body), state_(state) {
  using enum PointField;
  const mechanics::Discretization& discretization = body.discretization();
  const auto at_points = [&](PointField field) -> std::vector<double>& { return points_[number(field)]; };
  at_points(stress) = state.stress;
  discretization.fit_mean_stress(at_points(stress));
  at_points(creep_strain).assign(6 * n_points(), 0.0);
  if (!creep.empty())
    for (std::size_t p = 0; p < n_points(); ++p) tensor::writable(at_points(creep_strain), p) = creep.at(p);
  const mechanics::ElasticState elastic = conditions.elastic();
  at_points(strain) = at_points(creep_strain);
  for (std::size_t p = 0; p < n_points(); ++p) {
    tensor::Map total = tensor::writable(at_points(strain), p);
    total += material::elastic_strain(elastic.at(p), tensor_at(at_points(stress), p));
    if (!elastic.thermal_strain.empty()) total.head<3>().array() += elastic.thermal_strain[p];
  }
  at_points(temperature) = conditions.temperature;
  at_points(temperature).resize(n_points(), body.material().reference_temperature);
  at_points(damage) = std::move(measures.damage);
  at_points(life_fraction) = std::move(measures.life_fraction);
  for (const PointField field : point_fields) {
    const std::size_t width = is_tensor(field) ? 6 : 1;
    std::vector<double>& nodes = nodes_[number(field)];
    nodes.assign(width * n_nodes(), 0.0);
    at_points(field).resize(width * n_points(), 0.0);
    if (is_tensor(field))
      discretization.tensors_to_nodes(at_points(field), nodes);
    else
      discretization.to_nodes(at_points(field), 1, nodes);
  }
  // Extrapolation must not leave the interval that these have.
  for (const PointField field : {damage, life_fraction})
    for (double& value : nodes_[number(field)]) value = std::max(value, 0.0);
  for (double& value : nodes_[number(damage)]) value = std::min(value, 1.0);
}

Sample BodyFields::at_node(std::size_t node) const {
  using enum PointField;
  return {body_.mesh().nodes[node],
          Eigen::Map<const Vector3>(state_.displacement.data() + 3 * node),
          tensor_at(nodes_[number(stress)], node),
          tensor_at(nodes_[number(strain)], node),
          tensor_at(nodes_[number(creep_strain)], node),
          nodes_[number(temperature)][node],
          nodes_[number(damage)][node],
          nodes_[number(life_fraction)][node]};
}

Sample BodyFields::at_point(std::size_t point) const {
  using enum PointField;
  return {body_.discretization().point_coordinates()[point],
          Vector3::Zero(),
          tensor_at(points_[number(stress)], point),
          tensor_at(points_[number(strain)], point),
          tensor_at(points_[number(creep_strain)], point),
          points_[number(temperature)][point],
          points_[number(damage)][point],
          points_[number(life_fraction)][point]};
}

Snapshot::Snapshot(const creep::CreepSystem& system, double time, const creep::Evaluation& at)
    : system_(system), time_(time), at_(at) {}

const BodyFields& Snapshot::fields(std::size_t body) {
  const auto found = fields_.find(body);
  if (found != fields_.end()) return found->second;
  std::vector<mechanics::CreepStrainView> creep;
  system_.layout().views(at_.y, creep);
  return fields_
      .try_emplace(body, assembly().bodies()[body], at_.equilibrium.conditions[body], at_.equilibrium.bodies[body],
                   creep[body],
                   PointMeasures{.damage = system_.measure(material::Measure::damage, body, at_, at_.y),
                                 .life_fraction = system_.measure(material::Measure::life_fraction, body, at_, at_.y)})
      .first->second;
}

const std::vector<double>& Snapshot::reactions(std::size_t body) {
  std::vector<double>& forces = reactions_[body];
  if (!forces.empty()) return forces;
  const creep::BodyState& state = at_.equilibrium.bodies[body];
  forces.assign(state.displacement.size(), 0.0);
  // residual = reactions + contact forces
  std::vector<double> contact(forces.size(), 0.0);
  assembly().bodies()[body].residual_forces(at_.equilibrium.conditions[body], state.stress, forces);
  const contact::CondensedInterface& interface = system_.solver().interface();
  if (interface.n_rows() > 0) interface.add_contact_forces(body, at_.equilibrium.contact.multiplier, contact);
  for (std::size_t i = 0; i < forces.size(); ++i) forces[i] -= contact[i];
  return forces;
}

}  // namespace creepcontact::results
