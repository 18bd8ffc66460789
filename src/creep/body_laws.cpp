#include "creepcontact/creep/body_laws.hpp"

#include <algorithm>
#include <utility>

#include "plastic_points.hpp"

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

/// Whether the plasticity of a material gives a variable.
bool has_plastic(const material::Material& of, const material::StateVariable& variable) {
  if (of.plasticity == nullptr) return false;
  return &variable == &material::plastic_strain || &variable == &material::plastic_strain_equivalent ||
         &variable == &material::yield_stress || (&variable == &material::back_stress && of.plasticity->n_back() > 0);
}

/// Values of what has not flowed are zero.
std::vector<double> plastic_values(const material::StateVariable& variable, const mechanics::Body& body,
                                   const PlasticState& state, const mechanics::BodyConditions& at) {
  const std::size_t n = body.discretization().n_points();
  std::vector<double> values;
  if (&variable == &material::plastic_strain) values = state.strain;
  if (&variable == &material::plastic_strain_equivalent) values = state.accumulated;
  values.resize(n * static_cast<std::size_t>(variable.width()));
  const bool is_yield_stress = &variable == &material::yield_stress;
  if (!is_yield_stress && &variable != &material::back_stress) return values;
  const PlasticPoints points(body, at);
  for (std::size_t p = 0; p < n; ++p)
    if (is_yield_stress)
      values[p] = points.yield_stress(p, state.accumulated);
    else
      tensor::writable(values, p) = points.back_stress(p, state.back);
  return values;
}

}  // namespace

bool BodyLaws::has(const material::StateVariable& variable) const {
  return std::ranges::any_of(assembly_->bodies(),
                             [&](const mechanics::Body& body) { return has_plastic(body.material(), variable); }) ||
         std::ranges::any_of(points_, [&](const MaterialPoints& points) { return points.has(variable); });
}

std::vector<double> BodyLaws::evaluate(const material::StateVariable& variable, std::size_t body, const Evaluation& at,
                                       std::span<const double> y) const {
  const mechanics::Body& of = assembly_->bodies()[body];
  if (has_plastic(of.material(), variable) && !at.equilibrium.plastic.bodies.empty())
    return plastic_values(variable, of, at.equilibrium.plastic.bodies[body], at.equilibrium.conditions[body]);
  if (!points_[body].has(variable)) return {};
  return points_[body].evaluate(variable, state(body, at, y));
}

}  // namespace creepcontact::creep
