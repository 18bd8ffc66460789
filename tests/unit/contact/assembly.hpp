#pragma once
/// Two boxes, one on the other, in contact at z = 0: the lower from z = -height to 0, the upper from 0 to height.

#include "creepcontact/contact/condensed_interface.hpp"
#include "creepcontact/contact/solver/contact_solver.hpp"
#include "unit/mechanics/meshes.hpp"
#include "unit/mechanics/solve.hpp"

namespace creepcontact::test {

struct BoxSetup {
  mesh::CellType type = mesh::CellType::hex8;
  std::array<int, 3> divisions{2, 2, 2};
  double young_modulus = 200.0;
  Vector3 lengths{1, 1, 1};
  double distortion = 0.2;
};

struct Equilibrium {
  contact::ContactResult result;
  std::vector<std::vector<double>> stress, displacement;  // of every body
};

/// Elastic equilibrium at time t.
inline Equilibrium equilibrium(const std::vector<std::unique_ptr<mechanics::Body>>& bodies,
                               const contact::CondensedInterface& interface, contact::ContactSolver& solver, double t) {
  Equilibrium state;
  std::vector<std::vector<double>> y(bodies.size());
  for (const auto& body : bodies) body->set_time(t);
  contact::InterfaceLoad load = interface.initial_load(t);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    y[b].resize(static_cast<std::size_t>(bodies[b]->constraints().n_free()));
    bodies[b]->right_hand_side({}, y[b]);
    bodies[b]->clear_pins(y[b]);
    interface.add_resultant(b, load);
    bodies[b]->factor().forward(y[b], y[b]);
    interface.add_trace(b, y[b], load);
  }
  state.result = solver.solve(interface.contact_load(load), {});
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    std::vector<double> full(3 * bodies[b]->mesh().nodes.size());
    interface.add_multipliers(b, state.result.state.multiplier, y[b]);
    bodies[b]->factor().backward(y[b], y[b]);
    bodies[b]->constraints().expand(y[b], bodies[b]->prescribed(), full);
    interface.add_rigid_motion(b, state.result.state.rigid, full);
    state.stress.push_back(stress_of(*bodies[b], full));
    state.displacement.push_back(std::move(full));
  }
  return state;
}

/// Boxes with symmetry planes x = 0 and y = 0; the lower rests on z, the upper is held or pressed at its top.
class Assembly : public Equilibrium {
 public:
  /// @param top_displacement  of the upper box's top; none: it is held in z nowhere but in contact (not solvable here)
  Assembly(const BoxSetup& lower, const BoxSetup& upper, bool lower_is_slave, Function top_displacement,
           contact::ContactType type = contact::ContactType::unilateral, Function initial_gap = 0.0,
           double dense_bytes = contact::CondensedInterface::unbounded) {
    add(lower, Vector3(0, 0, -lower.lengths.z()), "z0", 0.0);
    add(upper, Vector3::Zero(), "z1", std::move(top_displacement));
    const contact::Surface low = surface(0, "z1"), up = surface(1, "z0");
    contact::Pair pair;
    pair.name = "joint";
    pair.slave_body = lower_is_slave ? 0 : 1;
    pair.master_body = lower_is_slave ? 1 : 0;
    pair.coupling = lower_is_slave ? contact::mortar_coupling(low, up, type) : contact::mortar_coupling(up, low, type);
    pair.gap = std::move(initial_gap);
    std::vector<contact::Pair> pairs{std::move(pair)};
    interface = std::make_unique<contact::CondensedInterface>(bodies, std::move(pairs), dense_bytes);
  }

  contact::Surface surface(std::size_t body, const std::string& name) const {
    return {name, &bodies[body]->mesh(), &bodies[body]->constraints(), mesh::boundary_faces(bodies[body]->mesh(), name),
            1.0};
  }

  void solve(contact::ContactSolver& solver, double t = 0) {
    static_cast<Equilibrium&>(*this) = equilibrium(bodies, *interface, solver, t);
  }

  std::vector<std::unique_ptr<mechanics::Body>> bodies;
  std::unique_ptr<contact::CondensedInterface> interface;

 private:
  void add(const BoxSetup& box, const Vector3& origin, const std::string& held, Function value) {
    mesh::Mesh mesh = box_mesh(box.type, box.divisions, box.lengths, origin, box.distortion);
    std::vector<mechanics::Support> supports{support(mesh, "x0", Vector3::UnitX()),
                                             support(mesh, "y0", Vector3::UnitY()),
                                             support(mesh, held, Vector3::UnitZ(), std::move(value))};
    bodies.push_back(std::make_unique<mechanics::Body>(bodies.empty() ? "lower" : "upper", std::move(mesh),
                                                       elastic_material(box.young_modulus), std::move(supports),
                                                       std::nullopt));
  }
};

}  // namespace creepcontact::test
