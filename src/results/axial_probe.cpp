#include <fmt/format.h>

#include "creepcontact/base/error.hpp"
#include "cross_section.hpp"
#include "probe_kinds.hpp"

namespace creepcontact::results {
namespace {

class CrossSectionProbe final : public Probe {
 public:
  CrossSectionProbe(std::size_t body, const OnCrossSection& section) : body_(body), section_(section) {}
  double value(Snapshot& snapshot) const override { return section_.evaluate(snapshot, body_); }

 private:
  std::size_t body_;
  OnCrossSection section_;
};

}  // namespace

double axial_strain(const Snapshot& snapshot, std::size_t body) {
  const mesh::Mesh& mesh = snapshot.assembly().bodies()[body].mesh();
  return snapshot.equilibrium().bodies[body].displacement[3 * mesh.axial_node + 2] / mesh.section.axial_length;
}

double axial_force(const Snapshot& snapshot, std::size_t body) {
  const mechanics::Body& of = snapshot.assembly().bodies()[body];
  const creep::BodyState& state = snapshot.equilibrium().bodies[body];
  const auto weights = of.discretization().weights();
  double force = 0;
  for (std::size_t p = 0; p < weights.size(); ++p) force += weights[p] * state.stress[6 * p + 2];
  return snapshot.assembly().team().sum(force) / of.mesh().section.thickness;
}

std::unique_ptr<Probe> make_probe(const OnCrossSection& section, const ProbeRequest& request) {
  const model::Model& model = request.model;
  const std::size_t body = model::find_body(model.bodies(), request.probe.body.name);
  if (model.bodies()[body].mesh().axial_node < 0)
    throw ModelError(
        fmt::format("'{}' exists in generalised plane strain only: analysis = \"generalized_plane_strain\"",
                    request.probe.quantity));
  return std::make_unique<CrossSectionProbe>(body, section);
}

}  // namespace creepcontact::results
