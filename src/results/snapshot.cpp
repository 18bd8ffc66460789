#include "creepcontact/results/snapshot.hpp"

#include <algorithm>

#include "creepcontact/creep/joint_values.hpp"
#include "creepcontact/results/probes.hpp"

namespace creepcontact::results {
namespace {

Tensor6 tensor_at(const std::vector<double>& values, std::size_t i) {
  return tensor::view(values, i);
}

constexpr std::size_t number(PointField field) {
  return static_cast<std::size_t>(field);
}

Vector3 vector_at(const std::vector<double>& values, std::size_t i) {
  return values.empty() ? Vector3::Zero() : Vector3(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
}

std::size_t state_width() {
  static const std::size_t width = [] {
    std::size_t sum = 0;
    for (const material::StateVariable* variable : material::state_variables()) sum += variable->width();
    return sum;
  }();
  return width;
}

/// Into rows of all state variables.
/// @param values  n rows of `width`, which get their place from column `first` on
void insert(const std::vector<double>& values, std::size_t width, std::size_t first, std::vector<double>& rows) {
  for (std::size_t i = 0; i < values.size(); ++i) rows[i / width * state_width() + first + i % width] = values[i];
}

std::vector<double> row(const std::vector<double>& rows, std::size_t number) {
  if (rows.empty()) return {};
  const auto first = rows.begin() + static_cast<std::ptrdiff_t>(number * state_width());
  return {first, first + static_cast<std::ptrdiff_t>(state_width())};
}

std::vector<double> to_nodes(const mechanics::Discretization& discretization, const std::vector<double>& at_points,
                             bool is_tensor) {
  std::vector<double> at_nodes((is_tensor ? 6 : 1) * discretization.n_nodes(), 0.0);
  if (is_tensor)
    discretization.tensors_to_nodes(at_points, at_nodes);
  else
    discretization.to_nodes(at_points, 1, at_nodes);
  return at_nodes;
}

/// The variables that are known, each with its first column in rows of all variables.
std::vector<std::pair<std::size_t, const PointState*>> columns(const std::vector<PointState>& variables) {
  std::vector<std::pair<std::size_t, const PointState*>> result;
  std::size_t first = 0;
  auto known = variables.begin();
  for (const material::StateVariable* variable : material::state_variables()) {
    if (known != variables.end() && known->variable == variable) result.emplace_back(first, &*known++);
    first += variable->width();
  }
  return result;
}

}  // namespace

BodyFields::BodyFields(const mechanics::Body& body, const mechanics::BodyConditions& conditions,
                       const creep::BodyState& state, mechanics::CreepStrainView creep,
                       std::vector<PointState> variables, BodyHeat heat)
    : body_(body),
      conditions_(conditions),
      state_(state),
      creep_(creep),
      variables_(std::move(variables)),
      heat_(std::move(heat)) {
  std::vector<double>& stress = points_[number(PointField::stress)];
  stress = state.stress;
  body.discretization().fit_mean_stress(stress);
  for (const PointState& variable : variables_)
    if (variable.variable == &material::plastic_strain) plastic_strain_ = &variable;
  if (variables_.empty()) return;
  state_at_points_.assign(state_width() * n_points(), 0.0);
  for (const auto& [first, known] : columns(variables_))
    insert(known->values, known->variable->width(), first, state_at_points_);
}

Tensor6 BodyFields::creep_strain_at(std::size_t point) const {
  return creep_.empty() ? Tensor6(Tensor6::Zero()) : Tensor6(creep_.at(point));
}

Tensor6 BodyFields::strain_at(std::size_t point) const {
  const mechanics::ElasticState elastic = conditions_.elastic();
  Tensor6 total = creep_strain_at(point);
  total += elastic.elastic_strain(point, tensor_at(points_[number(PointField::stress)], point));
  total += elastic.thermal(point);
  if (plastic_strain_ != nullptr) total += tensor_at(plastic_strain_->values, point);
  return total;
}

double BodyFields::temperature_at(std::size_t point) const {
  return conditions_.temperature.empty() ? body_.material().reference_temperature : conditions_.temperature[point];
}

const std::vector<double>& BodyFields::point_values(PointField field) const {
  std::vector<double>& values = points_[number(field)];
  if (!values.empty()) return values;
  if (field == PointField::temperature) {
    for (std::size_t p = 0; p < n_points(); ++p) values.push_back(temperature_at(p));
    return values;
  }
  values.resize(6 * n_points());
  for (std::size_t p = 0; p < n_points(); ++p)
    tensor::writable(values, p) = field == PointField::strain ? strain_at(p) : creep_strain_at(p);
  return values;
}

const BodyFields::Nodal& BodyFields::nodal() const {
  using enum PointField;
  if (nodal_) return *nodal_;
  const mechanics::Discretization& discretization = body_.discretization();
  Nodal& at_nodes = nodal_.emplace();
  std::vector<double> tensors(6 * n_tensors * n_points());
  for (const PointField field : {stress, strain, creep_strain}) {
    const std::vector<double>& values = point_values(field);
    for (std::size_t p = 0; p < n_points(); ++p)
      tensor::writable(tensors, n_tensors * p + number(field)) = tensor_at(values, p);
  }
  at_nodes.tensors.resize(6 * n_tensors * discretization.n_nodes());
  discretization.tensors_to_nodes(tensors, at_nodes.tensors);
  at_nodes.temperature =
      heat_.temperature.empty() ? to_nodes(discretization, point_values(temperature), false) : heat_.temperature;
  if (!heat_.flux.empty()) {
    at_nodes.heat_flux.resize(3 * discretization.n_nodes());
    discretization.to_nodes(heat_.flux, 3, at_nodes.heat_flux);
  }
  if (variables_.empty()) return at_nodes;
  at_nodes.state.assign(state_width() * discretization.n_nodes(), 0.0);
  for (const auto& [first, known] : columns(variables_)) {
    const material::StateVariable& variable = *known->variable;
    std::vector<double> values = to_nodes(discretization, known->values, variable.is_tensor);
    if (!variable.is_tensor)
      for (double& value : values) value = std::clamp(value, variable.minimum, variable.maximum);
    insert(values, variable.width(), first, at_nodes.state);
  }
  return at_nodes;
}

Sample BodyFields::at_node(std::size_t node) const {
  using enum PointField;
  const Nodal& at_nodes = nodal();
  return {body_.mesh().nodes[node],
          Eigen::Map<const Vector3>(state_.displacement.data() + 3 * node),
          tensor_at(at_nodes.tensors, n_tensors * node + number(stress)),
          tensor_at(at_nodes.tensors, n_tensors * node + number(strain)),
          tensor_at(at_nodes.tensors, n_tensors * node + number(creep_strain)),
          at_nodes.temperature[node],
          vector_at(at_nodes.heat_flux, node),
          row(at_nodes.state, node)};
}

Sample BodyFields::at_point(std::size_t point) const {
  using enum PointField;
  return {body_.discretization().point_coordinates()[point],
          Vector3::Zero(),
          tensor_at(points_[number(stress)], point),
          strain_at(point),
          creep_strain_at(point),
          temperature_at(point),
          vector_at(heat_.flux, point),
          row(state_at_points_, point)};
}

Snapshot::Snapshot(const creep::BodyLaws& laws, const contact::CondensedInterface& interface, double time,
                   const creep::Evaluation& at)
    : laws_(laws), interface_(interface), time_(time), at_(at) {}

Sample Snapshot::moved_node(std::size_t body, std::size_t node) const {
  const std::vector<double>& displacement = at_.equilibrium.bodies[body].displacement;
  return {.position = assembly().bodies()[body].mesh().nodes[node],
          .displacement = Eigen::Map<const Vector3>(displacement.data() + 3 * node)};
}

const BodyFields& Snapshot::fields(std::size_t body) {
  const auto found = fields_.find(body);
  if (found != fields_.end()) return found->second;
  std::vector<mechanics::CreepStrainView> creep;
  laws_.layout().views(at_.y, creep);
  std::vector<PointState> variables;
  for (const material::StateVariable* variable : material::state_variables())
    if (std::vector<double> values = laws_.evaluate(*variable, body, at_, at_.y); !values.empty())
      variables.push_back({variable, std::move(values)});
  BodyHeat heat;
  if (const heat::Definition* conduction = assembly().conduction()) {
    heat.temperature = computed_temperatures()[body];
    heat.flux = heat::flux(conduction->bodies[body], assembly().bodies()[body].discretization(), heat.temperature);
  }
  return fields_
      .try_emplace(body, assembly().bodies()[body], at_.equilibrium.conditions[body], at_.equilibrium.bodies[body],
                   creep[body], std::move(variables), std::move(heat))
      .first->second;
}

const std::vector<std::vector<double>>& Snapshot::computed_temperatures() {
  if (!temperatures_.empty() || assembly().conduction() == nullptr) return temperatures_;
  if (const creep::HeatModel* state = assembly().heat()) {
    for (const std::vector<int>& unknowns : state->unknown_of) {
      std::vector<double>& own = temperatures_.emplace_back();
      for (const int unknown : unknowns) own.push_back(at_.temperatures[static_cast<std::size_t>(unknown)]);
    }
    return temperatures_;
  }
  for (const mechanics::Body& body : assembly().bodies()) temperatures_.push_back(body.temperature_at_nodes(at_.time));
  return temperatures_;
}

const std::vector<heat::NodeOfInterface>& Snapshot::heat_of_contact() {
  const heat::Definition* conduction = assembly().conduction();
  if (!heat_of_contact_.empty() || conduction == nullptr) return heat_of_contact_;
  const creep::JointValues joint = creep::joint_values(assembly(), at_.equilibrium);
  heat_of_contact_ =
      heat::at_contact_nodes(*conduction, computed_temperatures(), at_.time, joint, joint.pressure.size());
  return heat_of_contact_;
}

const std::vector<double>& Snapshot::reactions(std::size_t body) {
  std::vector<double>& forces = reactions_[body];
  if (!forces.empty()) return forces;
  const creep::BodyState& state = at_.equilibrium.bodies[body];
  forces.assign(state.displacement.size(), 0.0);
  // residual = reactions + contact forces
  std::vector<double> contact(forces.size(), 0.0);
  assembly().bodies()[body].residual_forces(at_.equilibrium.conditions[body], state.stress, forces);
  if (interface_.n_rows() > 0) interface_.rows().add_contact_forces(body, at_.equilibrium.contact.multiplier, contact);
  for (std::size_t i = 0; i < forces.size(); ++i) forces[i] -= contact[i];
  return forces;
}

double Snapshot::value(const Probe& probe) {
  if (const auto found = values_.find(&probe); found != values_.end()) return found->second;
  const double value = probe.value(*this);
  values_.emplace(&probe, value);
  return value;
}

}  // namespace creepcontact::results
