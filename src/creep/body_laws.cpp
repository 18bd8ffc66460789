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

bool BodyLaws::has(const material::StateVariable& variable) const {
  return std::ranges::any_of(points_, [&](const MaterialPoints& points) { return points.has(variable); });
}

std::vector<double> BodyLaws::evaluate(const material::StateVariable& variable, std::size_t body, const Evaluation& at,
                                       std::span<const double> y) const {
  if (!points_[body].has(variable)) return {};
  return points_[body].evaluate(variable, state(body, at, y));
}

}  // namespace creepcontact::creep
