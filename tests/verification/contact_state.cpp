#include "verification/contact_state.hpp"

#include "creepcontact/base/index.hpp"

namespace creepcontact::test {

std::vector<ContactPoint> contact_points(const contact::Pair& pair, const mesh::Mesh& slave,
                                         const creep::Equilibrium& at) {
  std::vector<ContactPoint> points;
  const contact::MortarCoupling& coupling = pair.coupling;
  const Eigen::VectorXd multiplier = at.contact.multiplier.segment(pair.first_row, coupling.n_rows());
  for (std::size_t i = 0; i < pair.coupling.nodes.size(); ++i) {
    const contact::MultiplierNode& node = coupling.nodes[i];
    const double area = coupling.area[i];
    points.push_back({slave.nodes[node.node], node.normal, area, coupling.pressure(i, multiplier),
                      at.gaps[pair.first_row + coupling.row(i)] / area});
    if (!coupling.has_friction()) continue;
    points.back().shear = coupling.shear(i, multiplier);
    points.back().slip = at.friction.path[pair.first_node + static_cast<Index>(i)];
  }
  return points;
}

ContactState contact_state(const std::string& toml, const std::string& geo, const std::vector<std::string>& overrides,
                           double t, const std::vector<double>& accepted) {
  const CaseDirectory directory(geo);
  const config::Config config = directory.config(toml, overrides);
  const model::Model model = model::build_model(config);
  Stopwatch watch;
  creep::EquilibriumSolver solver(model.assembly, model.solver, watch);
  creep::CreepSystem system(solver, {}, config.time.tolerance, watch);
  for (const double before : accepted) system.accept(before, std::vector<double>(system.size()));
  const creep::Evaluation& at = system.evaluate_output(t, std::vector<double>(system.size()));
  results::Snapshot snapshot(system, t, at);

  ContactState state;
  const auto probes = results::make_probes(config, model);
  for (std::size_t i = 0; i < probes.size(); ++i) state.probes[config.probes[i].name] = probes[i]->value(snapshot);
  for (const contact::Pair& pair : model.pairs()) {
    state.slave[pair.name] = pair.slave_surface;
    if (pair.coupling.type == contact::ContactType::unilateral)
      state.pairs[pair.name] = contact_points(pair, model.bodies()[pair.slave_body].mesh(), at.equilibrium);
  }
  return state;
}

}  // namespace creepcontact::test
