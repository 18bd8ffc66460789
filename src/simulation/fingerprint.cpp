#include "fingerprint.hpp"

#include <fmt/format.h>

namespace creepcontact::simulation {

std::string fingerprint(const Model& model) {
  std::string text;
  for (const auto& body : model.bodies) {
    const material::Material& material = body->material();
    text +=
        fmt::format("{}: {} nodes, {} points, E {}, nu {};", body->name(), body->mesh().nodes.size(),
                    body->discretization().n_points(), material.young_modulus.text(), material.poisson_ratio.text());
    for (const auto& law : material.creep) {
      text += fmt::format(" {}", law->name());
      for (const Function& parameter : law->parameters()) text += fmt::format(" {}", parameter.text());
    }
    text += "\n";
  }
  return text;
}

}  // namespace creepcontact::simulation
