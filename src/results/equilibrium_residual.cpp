#include "creepcontact/results/equilibrium_residual.hpp"

#include <algorithm>
#include <cmath>

namespace creepcontact::results {
namespace {

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

}  // namespace

double equilibrium_residual(Snapshot& snapshot) {
  double unbalanced = 0, scale = 0;
  const creep::Assembly& assembly = snapshot.assembly();
  for (std::size_t b = 0; b < assembly.bodies().size(); ++b) {
    const mechanics::Body& body = assembly.bodies()[b];
    const std::vector<double>& reactions = snapshot.reactions(b);
    std::vector<double> free(static_cast<std::size_t>(body.constraints().n_free())), internal(reactions.size(), 0.0);
    body.constraints().restrict_to_free(reactions, free);
    body.discretization().add_internal_force(snapshot.equilibrium().bodies[b].stress, internal);
    unbalanced = std::max(unbalanced, largest(free));
    scale = std::max(scale, largest(internal));
  }
  scale = assembly.team().max(scale);
  return scale > 0 ? assembly.team().max(unbalanced) / scale : 0;
}

}  // namespace creepcontact::results
