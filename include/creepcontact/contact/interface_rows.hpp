#pragma once
/// The contact rows of all bodies and the loads on them: sparse products alone, nothing is factored.

#include <span>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/body_rows.hpp"
#include "creepcontact/contact/geometry/pair.hpp"
#include "creepcontact/contact/rigid_body_modes.hpp"
#include "creepcontact/contact/solver/problem.hpp"
#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::contact {

/// The loads as contact sees them, collected body by body.
struct InterfaceLoad {
  Eigen::VectorXd gap;    ///< weighted gaps without contact forces, n_rows
  Eigen::VectorXd work;   ///< of the external forces on unit rigid-body modes, RigidBodyModes::size()
  Eigen::VectorXd force;  ///< per rigid-body mode: sum of the absolute external forces on its body, the scale of `work`
  Friction friction = {};  ///< empty unless the problem has friction
  double time = 0;
  std::vector<ClosureCurve> curves = {};  ///< of gaskets, see ContactLoad::curves
};

/// The contact rows of all pairs on the dofs of the bodies. Constant after construction.
class InterfaceRows {
 public:
  /// One per body, in their order.
  using Conditions = std::span<const mechanics::BodyConditions>;

  /// @param bodies, pairs (numbered), rigid_body_modes (of both)  must outlive the object
  /// @throws ModelError as RigidBodyModes::require_contact
  InterfaceRows(std::span<const mechanics::Body> bodies, std::span<const Pair> pairs,
                const RigidBodyModes& rigid_body_modes);

  std::span<const Pair> pairs() const { return pairs_; }
  const RigidBodyModes& rigid_body_modes() const { return rigid_body_modes_; }
  Index n_rows() const { return problem_.n_rows(); }
  const BodyRows& operator[](std::size_t body) const { return of_body_[body]; }
  const std::vector<BodyRows>& of_bodies() const { return of_body_; }
  /// Nodes and rigid-body modes of the contact problem, without flexibilities.
  const ContactProblem& problem() const { return problem_; }

  /// A load with all entries zero.
  InterfaceLoad no_load() const;
  /// The load without creep, external forces and contact forces: initial gaps and prescribed displacements.
  /// @throws ModelError if a gap is not finite, or a coefficient of friction is not a number of at least 0
  InterfaceLoad initial_load(double t, Conditions at) const;
  /// Coefficients of friction; empty unless the problem has friction. @throws ModelError as initial_load()
  Friction friction(double t) const;
  /// What closures by creep open, on all rows. @param closures  per node of the contact problem; empty: no rows
  Eigen::VectorXd creep_gaps(std::span<const double> closures) const;
  /// Laws of the gaskets at time t, as ContactLoad::curves. @param largest  GasketHistory::largest
  std::vector<ClosureCurve> gasket_curves(double t, const Eigen::VectorXd& largest) const;
  /// Weighted distances of the surfaces at t = 0 before loads and interference are applied (n_rows): the given gaps,
  /// with each pair whose surfaces overlap moved apart until they just touch.
  Eigen::VectorXd unloaded_gap() const;
  /// Adds the work of the external forces of a body on its rigid-body modes.
  void add_resultant(std::size_t body, const mechanics::BodyConditions& at, InterfaceLoad& load) const;
  /// gap += B u. @param u  displacement on the free dofs of the body
  void add_gaps(std::size_t body, std::span<const double> u, Eigen::VectorXd& gap) const;
  /// displacement (3 n_nodes) += the rigid-body motion of the body. @param rigid  amplitudes, n_motions of the contact
  /// problem
  void add_rigid_motion(std::size_t body, const Eigen::VectorXd& rigid, std::span<double> displacement) const;
  /// forces (3 n_nodes) += nodal forces of the multipliers on a body.
  void add_contact_forces(std::size_t body, const Eigen::VectorXd& multiplier, std::span<double> forces) const;

 private:
  void add_body(std::size_t b);

  std::span<const mechanics::Body> bodies_;
  std::span<const Pair> pairs_;
  const RigidBodyModes& rigid_body_modes_;
  ContactProblem problem_;
  std::vector<BodyRows> of_body_;
};

}  // namespace creepcontact::contact
