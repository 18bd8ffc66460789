/// The axial strain in generalised plane strain: common to all bodies, or one of each.

#include <fmt/format.h>

#include <numeric>

#include "creepcontact/contact/geometry/node_ties.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {
namespace {

bool is_unknown(const config::Config& config) {
  return config.analysis == settings::Analysis::generalized_plane_strain && !config.generalized_plane_strain.strain;
}

double cross_section(const mechanics::Body& body) {
  const auto weights = body.discretization().weights();
  return std::reduce(weights.begin(), weights.end()) / body.mesh().section.thickness;
}

}  // namespace

void prescribe_axial_strain(const config::Config& config, const BodyMeshes& meshes,
                            std::vector<std::vector<mechanics::Support>>& supports) {
  if (config.analysis != settings::Analysis::generalized_plane_strain || is_unknown(config)) return;
  const Function& strain = *config.generalized_plane_strain.strain;
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    const double length = meshes[b].section.axial_length;
    supports[b].push_back(
        {.on = "axial strain",
         .nodes = {meshes[b].axial_node},
         .directions = {Vector3::UnitZ()},
         .value = Function::composed(fmt::format("({}) * {}", strain.text(), length), {strain},
                                     [length](const std::vector<double>& values) { return length * values[0]; })});
  }
}

void share_axial_strain(const config::Config& config, Bodies& bodies, std::vector<contact::Pair>& pairs) {
  if (!is_unknown(config)) return;
  if (config.generalized_plane_strain.per_body) {
    for (std::size_t b = 0; b < bodies.size(); ++b)
      if (const auto& force = config.bodies[b].axial_force; force && !force->is_zero())
        bodies[b].add_load(mechanics::axial_load(bodies[b].mesh(), *force));
    return;
  }
  mechanics::Body& first = bodies.front();
  if (!config.generalized_plane_strain.force.is_zero())
    first.add_load(mechanics::axial_load(first.mesh(), config.generalized_plane_strain.force));
  for (std::size_t b = 1; b < bodies.size(); ++b) {
    const mechanics::Body& body = bodies[b];
    contact::Pair pair;
    pair.name = fmt::format("axial strain of '{}' and '{}'", first.name(), body.name());
    pair.slave_body = b;
    const contact::NodeTie tie{body.mesh().axial_node, first.mesh().axial_node, cross_section(body)};
    pair.coupling =
        contact::node_ties({&body.mesh(), &body.constraints()}, {&first.mesh(), &first.constraints()}, {&tie, 1});
    pairs.push_back(std::move(pair));
  }
}

}  // namespace creepcontact::model
