#include "creepcontact/creep/body_laws.hpp"

#include <algorithm>
#include <utility>

namespace creepcontact::creep {

BodyLaws::BodyLaws(const Assembly& assembly, std::vector<double> min_strain)
    : assembly_(&assembly), min_strain_(std::move(min_strain)), layout_(assembly) {
  for (std::size_t b = 0; b < assembly.bodies().size(); ++b) points_.emplace_back(assembly.bodies()[b], min_strain_[b]);
}

PointsState BodyLaws::state(std::size_t body, const Evaluation& at, std::span<const double> y) const {
  return {at.laws[body], at.equilibrium.conditions[body].elastic(), at.equilibrium.bodies[body].stress,
          layout_.part(body, y)};
}

namespace {

bool is_plastic(const material::StateVariable& variable) {
  return &variable == &material::plastic_strain || &variable == &material::plastic_strain_equivalent;
}

/// Values of what has not flowed are zero.
std::vector<double> plastic_values(const material::StateVariable& variable, const PlasticState& state,
                                   std::size_t n_points) {
  const bool is_tensor = &variable == &material::plastic_strain;
  std::vector<double> values = is_tensor ? state.strain : state.accumulated;
  values.resize(n_points * static_cast<std::size_t>(variable.width()));
  return values;
}

}  // namespace

bool BodyLaws::has(const material::StateVariable& variable) const {
  if (is_plastic(variable))
    return std::ranges::any_of(assembly_->bodies(),
                               [](const mechanics::Body& body) { return body.material().plasticity != nullptr; });
  return std::ranges::any_of(points_, [&](const MaterialPoints& points) { return points.has(variable); });
}

std::vector<double> BodyLaws::evaluate(const material::StateVariable& variable, std::size_t body, const Evaluation& at,
                                       std::span<const double> y) const {
  if (is_plastic(variable)) {
    if (assembly_->bodies()[body].material().plasticity == nullptr || at.equilibrium.plastic.bodies.empty()) return {};
    return plastic_values(variable, at.equilibrium.plastic.bodies[body],
                          assembly_->bodies()[body].discretization().n_points());
  }
  if (!points_[body].has(variable)) return {};
  return points_[body].evaluate(variable, state(body, at, y));
}

}  // namespace creepcontact::creep
