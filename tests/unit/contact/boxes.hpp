#pragma once
/// Two boxes, one on the other, in contact at z = 0: the lower from z = -height to 0, the upper from 0 to height.

#include "creepcontact/base/index.hpp"
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

struct ContactEquilibrium {
  contact::ContactResult result;
  std::vector<std::vector<double>> stress, displacement;  // of every body
};

using Bodies = std::vector<mechanics::Body>;

inline std::vector<mechanics::BodyConditions> conditions(const Bodies& bodies, double t) {
  std::vector<mechanics::BodyConditions> at;
  for (const mechanics::Body& body : bodies) at.push_back(body.at(t));
  return at;
}

/// Bodies condensed onto the contact of their pairs, with all that this refers to.
class Condensed {
 public:
  Condensed(Bodies bodies_in, std::vector<contact::Pair> pairs_in,
            double dense_bytes = contact::CondensedInterface::unbounded, double factored_at = 0)
      : bodies(std::move(bodies_in)),
        pairs(std::move(pairs_in)),
        n_rows(contact::number_rows(pairs)),
        floating(bodies, pairs),
        interface(bodies, pairs, floating, conditions(bodies, factored_at), dense_bytes) {}

  /// The load for the contact solver at time t. @param y  receives L^-1 P f of every body
  contact::ContactLoad load(double t, std::vector<std::vector<double>>& y) {
    const std::vector<mechanics::BodyConditions> at = conditions(bodies, t);
    contact::InterfaceLoad load = interface.initial_load(t, at);
    y.resize(bodies.size());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      y[b].resize(bodies[b].constraints().n_free());
      bodies[b].right_hand_side(at[b], {}, y[b]);
      bodies[b].clear_pins(y[b]);
      interface.add_resultant(b, at[b], load);
      interface.factored(b).solver().forward(y[b], y[b]);
      interface.add_trace(b, y[b], load.gap);
    }
    return interface.contact_load(load);
  }

  /// Elastic equilibrium at time t.
  ContactEquilibrium solve(contact::ContactSolver& solver, double t = 0) {
    ContactEquilibrium state;
    std::vector<std::vector<double>> y;
    state.result = solver.solve(load(t, y), {});
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      std::vector<double> full(3 * bodies[b].mesh().nodes.size());
      interface.add_multipliers(b, state.result.state.multiplier, y[b]);
      interface.factored(b).solver().backward(y[b], y[b]);
      bodies[b].constraints().expand(y[b], bodies[b].at(t).prescribed, full);
      interface.add_rigid_motion(b, state.result.state.rigid, full);
      state.stress.push_back(stress_of(bodies[b], full, t));
      state.displacement.push_back(std::move(full));
    }
    return state;
  }

  const Bodies bodies;
  std::vector<contact::Pair> pairs;
  Index n_rows;
  contact::FloatingMotions floating;
  contact::CondensedInterface interface;
};

/// Boxes with symmetry planes x = 0 and y = 0; the lower rests on z, the upper is held or pressed at its top.
class Boxes : public ContactEquilibrium {
 public:
  /// @param top_displacement  of the upper box's top; none: it is held in z nowhere but in contact (not solvable here)
  Boxes(const BoxSetup& lower, const BoxSetup& upper, bool lower_is_slave, Function top_displacement,
        contact::ContactType type = contact::ContactType::unilateral, Function initial_gap = 0.0,
        double dense_bytes = contact::CondensedInterface::unbounded) {
    Bodies bodies;
    bodies.push_back(body("lower", lower, Vector3(0, 0, -lower.lengths.z()), "z0", 0.0));
    bodies.push_back(body("upper", upper, Vector3::Zero(), "z1", std::move(top_displacement)));
    const contact::Surface low = surface(bodies[0], "z1"), up = surface(bodies[1], "z0");
    contact::Pair pair;
    pair.name = "joint";
    pair.slave_body = lower_is_slave ? 0 : 1;
    pair.master_body = lower_is_slave ? 1 : 0;
    pair.coupling = lower_is_slave ? contact::mortar_coupling(low, up, type) : contact::mortar_coupling(up, low, type);
    pair.gap = std::move(initial_gap);
    condensed_ =
        std::make_unique<Condensed>(std::move(bodies), std::vector<contact::Pair>{std::move(pair)}, dense_bytes);
  }

  static contact::Surface surface(const mechanics::Body& body, const std::string& name) {
    return {name, &body.mesh(), &body.constraints(), mesh::boundary_faces(body.mesh(), name), 1.0};
  }

  void solve(contact::ContactSolver& solver, double t = 0) {
    static_cast<ContactEquilibrium&>(*this) = condensed_->solve(solver, t);
  }
  const Bodies& bodies() const { return condensed_->bodies; }
  contact::CondensedInterface& interface() { return condensed_->interface; }
  const contact::CondensedInterface& interface() const { return condensed_->interface; }
  Condensed& condensed() { return *condensed_; }

 private:
  static mechanics::Body body(const std::string& name, const BoxSetup& box, const Vector3& origin,
                              const std::string& held, Function value) {
    mesh::Mesh mesh = box_mesh(box.type, box.divisions, box.lengths, origin, box.distortion);
    std::vector<mechanics::Support> supports{support(mesh, "x0", Vector3::UnitX()),
                                             support(mesh, "y0", Vector3::UnitY()),
                                             support(mesh, held, Vector3::UnitZ(), std::move(value))};
    return {name, std::move(mesh), elastic_material(box.young_modulus), std::move(supports), std::nullopt};
  }

  std::unique_ptr<Condensed> condensed_;
};

}  // namespace creepcontact::test
