#include "heat_alone.hpp"

#include <numeric>
#include <utility>

namespace creepcontact::model {

config::Config without_mechanics(config::Config config) {
  config.supports.clear();
  config.loads.clear();
  config.contacts.clear();
  config.springs.clear();
  config.equations.clear();
  config.rigid.clear();
  config.coupling.clear();
  config.cyclic.clear();
  config.gaskets.clear();
  config.initial_stress.clear();
  config.generalized_plane_strain = {};
  config.mesh.share_nodes = {};
  for (config::Material& material : config.materials) {
    config::Material heat_alone;
    heat_alone.name = material.name;
    heat_alone.location = material.location;
    heat_alone.young_modulus = 1;
    heat_alone.poisson_ratio = 0;
    material = std::move(heat_alone);
  }
  return config;
}

std::vector<mechanics::Support> hold(const mesh::Mesh& body) {
  std::vector<std::int64_t> nodes(body.nodes.size());
  std::iota(nodes.begin(), nodes.end(), std::int64_t{0});
  std::vector<mechanics::Support> result;
  for (const Vector3& direction : {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)})
    result.push_back({.on = "all nodes", .nodes = nodes, .directions = {direction}, .value = 0.0});
  return result;
}

}  // namespace creepcontact::model
