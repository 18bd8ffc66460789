#include <fmt/format.h>

#include "creepcontact/base/error.hpp"
#include "probe_kinds.hpp"

namespace creepcontact::results {
namespace {

class AxialProbe final : public Probe {
 public:
  AxialProbe(std::size_t body, bool is_force) : body_(body), is_force_(is_force) {}

  double value(Snapshot& snapshot) const override {
    const mechanics::Body& body = snapshot.assembly().bodies()[body_];
    const creep::BodyState& state = snapshot.equilibrium().bodies[body_];
    if (!is_force_) return state.displacement[3 * body.mesh().axial_node + 2] / body.mesh().section.axial_length;
    const auto weights = body.discretization().weights();
    double force = 0;
    for (std::size_t p = 0; p < weights.size(); ++p) force += weights[p] * state.stress[6 * p + 2];
    return snapshot.assembly().team().sum(force) / body.mesh().section.thickness;
  }

 private:
  std::size_t body_;
  bool is_force_;
};

}  // namespace

std::unique_ptr<Probe> axial_probe(const config::Probe& probe, const model::Model& model) {
  const std::size_t body = model::find_body(model.bodies(), probe.body.name);
  if (model.bodies()[body].mesh().axial_node < 0)
    throw ModelError(fmt::format(
        "'{}' exists in generalised plane strain only: analysis = \"generalized_plane_strain\"", probe.quantity));
  return std::make_unique<AxialProbe>(
      body, quantity(probe.quantity).variable->location == OutputVariable::Location::axial_force);
}

}  // namespace creepcontact::results
