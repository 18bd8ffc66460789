#pragma once
/// Two boxes, one on the other, in contact at z = 0: the lower from z = -height to 0, the upper from 0 to height.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/condensed_interface.hpp"
#include "creepcontact/contact/solver/contact_solver.hpp"
#include "support/mechanics/meshes.hpp"
#include "support/mechanics/solve.hpp"

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

std::vector<mechanics::BodyConditions> conditions(const Bodies& bodies, double t);

/// Bodies condensed onto the contact of their pairs, with all that this refers to.
class Condensed {
 public:
  Condensed(Bodies bodies_in, std::vector<contact::Pair> pairs_in,
            double dense_bytes = contact::CondensedInterface::unbounded, double factored_at = 0);

  /// The load for the contact solver at time t. @param y  receives L^-1 P f of every body
  contact::ContactLoad load(double t, std::vector<std::vector<double>>& y);

  /// Elastic equilibrium at time t.
  ContactEquilibrium solve(contact::ContactSolver& solver, double t = 0);

  const Bodies bodies;
  std::vector<contact::Pair> pairs;
  Index n_rows;
  contact::RigidBodyModes floating;
  contact::CondensedInterface interface;
};

/// Boxes with symmetry planes x = 0 and y = 0; the lower rests on z, the upper is held or pressed at its top.
class Boxes : public ContactEquilibrium {
 public:
  /// @param top_displacement  of the upper box's top; none: it is held in z nowhere but in contact (not solvable here)
  Boxes(const BoxSetup& lower, const BoxSetup& upper, bool lower_is_slave, Function top_displacement,
        contact::ContactType type = contact::ContactType::unilateral, Function initial_gap = 0.0,
        double dense_bytes = contact::CondensedInterface::unbounded, double friction = 0);

  static contact::Surface surface(const mechanics::Body& body, const std::string& name);

  void solve(contact::ContactSolver& solver, double t = 0);
  const Bodies& bodies() const { return condensed_->bodies; }
  contact::CondensedInterface& interface() { return condensed_->interface; }
  const contact::CondensedInterface& interface() const { return condensed_->interface; }
  Condensed& condensed() { return *condensed_; }

 private:
  static mechanics::Body body(const std::string& name, const BoxSetup& box, const Vector3& origin,
                              const std::string& held, Function value);

  std::unique_ptr<Condensed> condensed_;
};

}  // namespace creepcontact::test
