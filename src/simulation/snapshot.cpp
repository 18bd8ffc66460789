#include "creepcontact/simulation/snapshot.hpp"

#include <algorithm>

namespace creepcontact::simulation {
namespace {

Tensor6 tensor_at(const std::vector<double>& values, std::size_t i) {
  return Eigen::Map<const Tensor6>(values.data() + 6 * i);
}

}  // namespace

BodyFields::BodyFields(mechanics::Body& body, const BodyState& state, mechanics::CreepStrainView creep, double time,
                       std::vector<double> damage_at_points, std::vector<double> life_at_points)
    : body_(body), state_(state) {
  const mechanics::Discretization& discretization = body.discretization();
  points_[stress] = state.stress;
  discretization.fit_mean_stress(points_[stress]);
  points_[creep_strain].assign(6 * n_points(), 0.0);
  if (creep.data != nullptr)
    for (std::size_t p = 0; p < n_points(); ++p)
      std::copy_n(creep.data + p * creep.stride, 6, points_[creep_strain].data() + 6 * p);
  const mechanics::ElasticState elastic = body.elastic();
  points_[strain] = points_[creep_strain];
  for (std::size_t p = 0; p < n_points(); ++p) {
    Eigen::Map<Tensor6> total(points_[strain].data() + 6 * p);
    total += material::elastic_strain(elastic.at(p), tensor_at(points_[stress], p));
    if (!elastic.thermal_strain.empty()) total.head<3>().array() += elastic.thermal_strain[p];
  }
  const std::span<const double> at_points = body.temperature(time);
  points_[temperature].assign(at_points.begin(), at_points.end());
  points_[temperature].resize(n_points(), body.material().reference_temperature);
  points_[damage] = std::move(damage_at_points);
  points_[life_fraction] = std::move(life_at_points);
  for (const int field : {stress, strain, creep_strain, temperature, damage, life_fraction}) {
    const int width = field >= temperature ? 1 : 6;
    nodes_[field].assign(static_cast<std::size_t>(width) * n_nodes(), 0.0);
    points_[field].resize(static_cast<std::size_t>(width) * n_points(), 0.0);
    if (width == 6)
      discretization.tensors_to_nodes(points_[field], nodes_[field]);
    else
      discretization.to_nodes(points_[field], width, nodes_[field]);
  }
  // Extrapolation must not leave the interval that these have.
  for (const int field : {damage, life_fraction})
    for (double& value : nodes_[field]) value = std::max(value, 0.0);
  for (double& value : nodes_[damage]) value = std::min(value, 1.0);
}

Sample BodyFields::at_node(std::size_t node) const {
  return {body_.mesh().nodes[node],
          Eigen::Map<const Vector3>(state_.displacement.data() + 3 * node),
          tensor_at(nodes_[stress], node),
          tensor_at(nodes_[strain], node),
          tensor_at(nodes_[creep_strain], node),
          nodes_[temperature][node],
          nodes_[damage][node],
          nodes_[life_fraction][node]};
}

Sample BodyFields::at_point(std::size_t point) const {
  return {body_.discretization().point_coordinates()[point],
          Vector3::Zero(),
          tensor_at(points_[stress], point),
          tensor_at(points_[strain], point),
          tensor_at(points_[creep_strain], point),
          points_[temperature][point],
          points_[damage][point],
          points_[life_fraction][point]};
}

Snapshot::Snapshot(const ContactElasticity& elasticity, const StateLayout& layout, double time,
                   std::span<const double> y)
    : elasticity_(elasticity), time_(time), y_(y) {
  layout.views(y, creep_);
}

Snapshot::Snapshot(const CreepRate& system, double time, std::span<const double> y)
    : Snapshot(system.elasticity(), system.layout(), time, y) {
  system_ = &system;
}

std::vector<double> Snapshot::measure(material::Measure of, std::size_t body) const {
  return system_ ? system_->measure(of, body, y_) : std::vector<double>{};
}

const BodyFields& Snapshot::fields(std::size_t body) const {
  const auto found = fields_.find(body);
  if (found != fields_.end()) return found->second;
  return fields_
      .try_emplace(body, *elasticity_.model().bodies[body], elasticity_.states()[body], creep_[body],
                   elasticity_.time(), measure(material::Measure::damage, body),
                   measure(material::Measure::life_fraction, body))
      .first->second;
}

const std::vector<double>& Snapshot::reactions(std::size_t body) const {
  std::vector<double>& forces = reactions_[body];
  if (!forces.empty()) return forces;
  const mechanics::Body& owner = *elasticity_.model().bodies[body];
  const BodyState& state = elasticity_.states()[body];
  forces.assign(state.displacement.size(), 0.0);
  // residual = reactions + contact forces
  std::vector<double> contact(forces.size(), 0.0);
  owner.residual_forces(state.stress, forces);
  if (elasticity_.interface().n_rows() > 0)
    elasticity_.interface().add_contact_forces(body, elasticity_.multipliers(), contact);
  for (std::size_t i = 0; i < forces.size(); ++i) forces[i] -= contact[i];
  return forces;
}

}  // namespace creepcontact::simulation
