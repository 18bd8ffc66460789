#include "support/contact/boxes.hpp"

#include <optional>
#include <utility>

namespace creepcontact::test {

std::vector<mechanics::BodyConditions> conditions(const Bodies& bodies, double t) {
  std::vector<mechanics::BodyConditions> at;
  for (const mechanics::Body& body : bodies) at.push_back(body.at(t));
  return at;
}

Condensed::Condensed(Bodies bodies_in, std::vector<contact::Pair> pairs_in, double dense_bytes, double factored_at)
    : bodies(std::move(bodies_in)),
      pairs(std::move(pairs_in)),
      n_rows(contact::number_rows(pairs)),
      floating(bodies, pairs),
      interface(bodies, pairs, floating, conditions(bodies, factored_at), dense_bytes) {}

contact::ContactLoad Condensed::load(double t, std::vector<std::vector<double>>& y) {
  const std::vector<mechanics::BodyConditions> at = conditions(bodies, t);
  contact::InterfaceLoad load = interface.rows().initial_load(t, at);
  y.resize(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    y[b].resize(bodies[b].constraints().n_free());
    bodies[b].right_hand_side(at[b], {}, y[b]);
    bodies[b].clear_fixing_dofs(y[b]);
    interface.rows().add_resultant(b, at[b], load);
    interface.factored(b).solver().forward(y[b], y[b]);
    interface.flexibility().add_trace(b, y[b], load.gap);
  }
  return interface.balance().contact_load(load);
}

ContactEquilibrium Condensed::solve(contact::ContactSolver& solver, double t) {
  ContactEquilibrium state;
  std::vector<std::vector<double>> y;
  state.result = solver.solve(load(t, y), {});
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    std::vector<double> full(3 * bodies[b].mesh().nodes.size());
    interface.flexibility().add_multipliers(b, state.result.state.multiplier, y[b]);
    interface.factored(b).solver().backward(y[b], y[b]);
    bodies[b].constraints().expand(y[b], bodies[b].at(t).prescribed, full);
    interface.rows().add_rigid_motion(b, state.result.state.rigid, full);
    state.stress.push_back(stress_of(bodies[b], full, t));
    state.displacement.push_back(std::move(full));
  }
  return state;
}

Boxes::Boxes(const BoxSetup& lower, const BoxSetup& upper, bool lower_is_slave, Function top_displacement,
             contact::ContactType type, Function initial_gap, double dense_bytes, double friction) {
  Bodies bodies;
  bodies.push_back(body("lower", lower, Vector3(0, 0, -lower.lengths.z()), "z0", 0.0));
  bodies.push_back(body("upper", upper, Vector3::Zero(), "z1", std::move(top_displacement)));
  const contact::Surface low = surface(bodies[0], "z1"), up = surface(bodies[1], "z0");
  contact::Pair pair;
  pair.name = "joint";
  pair.slave_body = lower_is_slave ? 0 : 1;
  pair.master_body = lower_is_slave ? 1 : 0;
  const contact::Surface &slave = lower_is_slave ? low : up, &master = lower_is_slave ? up : low;
  pair.coupling = contact::mortar_coupling(slave, master, type, {}, friction > 0);
  std::vector<Vector3> positions;
  for (const contact::MultiplierNode& node : pair.coupling.nodes) positions.push_back(slave.mesh->nodes[node.node]);
  pair.friction = {friction, std::nullopt, std::move(positions)};
  pair.gap = std::move(initial_gap);
  condensed_ = std::make_unique<Condensed>(std::move(bodies), std::vector<contact::Pair>{std::move(pair)}, dense_bytes);
}

contact::Surface Boxes::surface(const mechanics::Body& body, const std::string& name) {
  return {name, &body.mesh(), &body.constraints(), mesh::boundary_faces(body.mesh(), name), 1.0};
}

void Boxes::solve(contact::ContactSolver& solver, double t) {
  static_cast<ContactEquilibrium&>(*this) = condensed_->solve(solver, t);
}

mechanics::Body Boxes::body(const std::string& name, const BoxSetup& box, const Vector3& origin,
                            const std::string& held, Function value) {
  mesh::Mesh mesh = box_mesh(box.type, box.divisions, box.lengths, origin, box.distortion);
  std::vector<mechanics::Support> supports{support(mesh, "x0", Vector3::UnitX()), support(mesh, "y0", Vector3::UnitY()),
                                           support(mesh, held, Vector3::UnitZ(), std::move(value))};
  return {name, std::move(mesh), elastic_material(box.young_modulus), std::move(supports), std::nullopt};
}

}  // namespace creepcontact::test
