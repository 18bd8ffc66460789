#pragma once
/// Energy norms of stresses.

#include <cmath>
#include <vector>

#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/creep/equilibrium.hpp"
#include "creepcontact/numerics/point_sums.hpp"

namespace creepcontact::creep {

/// Twice the elastic energy, integral sigma H^-1 sigma. @param stress  n_points x 6
inline double elastic_energy(const mechanics::Discretization& discretization, const mechanics::ElasticState& elastic,
                             const std::vector<double>& stress) {
  const std::span<const double> weights = discretization.weights();
  return numerics::sum_over_points(stress.size() / 6, [&](std::size_t p) {
    const tensor::ConstMap sigma = tensor::view(stress, p);
    return weights[p] * sigma.dot(elastic.elastic_strain(p, sigma));
  });
}

/// The energy norm of the stress of all bodies. Collective.
inline double stress_norm(const Assembly& assembly, const Equilibrium& of) {
  double sum = 0;
  for (std::size_t b = 0; b < of.bodies.size(); ++b)
    sum += elastic_energy(assembly.bodies()[b].discretization(), of.conditions[b].elastic(), of.bodies[b].stress);
  return std::sqrt(assembly.team().sum(sum));
}

}  // namespace creepcontact::creep
