#pragma once
/// All contact pairs condensed onto their multipliers. K = L L^T is factored with the contact dofs of each body last.
/// Let B be the rows of the weighted gaps of a body, and L22 the trailing block of L. Then G = L22^-1 B^T contains all
/// that contact needs:
///   y = L^-1 f,   gap = initial gap + G^T y2,   contact forces: y2 += G lambda,   u = L^-T y,   F = G^T G.
/// Contact therefore needs no substitutions of its own.
///
/// If the dense matrices would exceed a bound, the bodies are factored without this ordering: G = L^-1 P B^T is applied
/// by additional substitutions, and a product with F costs one forward and one back substitution.
/// Solvers without a factor are used in the same way, with L = I and G = B^T; within the bound on dense matrices, F is
/// then computed column by column.

#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/base/team.hpp"
#include "creepcontact/contact/body_rows.hpp"
#include "creepcontact/contact/condensed_rows.hpp"
#include "creepcontact/contact/rigid_body_modes.hpp"
#include "creepcontact/contact/solver/problem.hpp"
#include "creepcontact/mechanics/body.hpp"
#include "creepcontact/mechanics/factored_body.hpp"

namespace creepcontact::contact {

/// The loads as contact sees them, collected body by body.
struct InterfaceLoad {
  Eigen::VectorXd gap;    ///< weighted gaps without contact forces, n_rows
  Eigen::VectorXd work;   ///< of the external forces on unit rigid-body modes, RigidBodyModes::size()
  Eigen::VectorXd force;  ///< per rigid-body mode: sum of the absolute external forces on its body, the scale of `work`
  Friction friction = {};  ///< empty unless the problem has friction
  double time = 0;
};

class FactoredFlexibility;

/// The loads move a body that only contact with friction holds. Within a run a smaller step may avoid it.
class SlidingOff : public ModelError {
 public:
  using ModelError::ModelError;
};

/// The condensed contact problem of all bodies, and their factors. Use from one thread at a time.
class CondensedInterface {
 public:
  /// One per body, in their order.
  using Conditions = std::span<const mechanics::BodyConditions>;
  /// Called between analysis and factorisation, when the sizes of all factors are known but their memory is not yet
  /// allocated. It may throw to refuse the model. @param dense_bytes  size of the dense matrices that will be made
  using Admission = std::function<void(const CondensedInterface& analyzed, double dense_bytes)>;
  /// Factors every body with its contact dofs last and condenses the contact rows.
  /// @param bodies, pairs (numbered), rigid_body_modes (of both)  must outlive the object
  /// @param at  conditions of all bodies, whose stiffness is factored
  /// @param dense_bytes  bound on the dense matrices, in bytes; beyond it the flexibility is an operator
  /// @param admit  see Admission
  /// @param team  the processes that share the bodies, and their solvers; must outlive the object. Only its member 0
  /// has the dense matrices (is_here())
  /// @throws ModelError as FactoredBody::factorize and RigidBodyModes::require_contact
  /// Cost: the factorisations, and n_contact^2 x n_rows operations per body.
  CondensedInterface(std::span<const mechanics::Body> bodies, std::span<const Pair> pairs,
                     const RigidBodyModes& rigid_body_modes, Conditions at, double dense_bytes = unbounded,
                     const Admission& admit = {},
                     const linalg::StiffnessSolverFactory& make_solver = linalg::default_stiffness_solver,
                     const Team& team = serial_team());
  ~CondensedInterface();
  static constexpr double unbounded = std::numeric_limits<double>::infinity();

  /// Factors and condenses these bodies again, with the stiffness of these conditions. The caller must then call
  /// flexibility_changed() of all contact solvers and systems that use problem().
  /// Cost: as the constructor, without analysis and ordering.
  void refactorize(std::span<const std::size_t> bodies, Conditions at);

  std::span<const Pair> pairs() const { return pairs_; }
  mechanics::FactoredBody& factored(std::size_t body) { return factored_[body]; }
  const mechanics::FactoredBody& factored(std::size_t body) const { return factored_[body]; }
  const ContactProblem& problem() const { return problem_; }
  const RigidBodyModes& rigid_body_modes() const { return rigid_body_modes_; }
  Index n_rows() const { return problem_.n_rows(); }
  /// See immovable_rows(); of the first factors.
  const std::vector<int>& immovable() const { return immovable_; }
  const BodyRows& rows(std::size_t body) const { return rows_[body]; }
  /// Free dofs that the factor of the body eliminates last: those that its contact rows touch. Only if is_condensed().
  std::span<const std::int64_t> trailing(std::size_t body) const { return sides_[body].trailing; }
  /// True if contact is condensed onto the trailing dofs of the bodies' factors.
  bool is_condensed() const { return is_condensed_; }

  /// The load without creep, external forces and contact forces: initial gaps and prescribed displacements.
  /// @throws ModelError if a gap is not finite, or a coefficient of friction is not a number of at least 0
  InterfaceLoad initial_load(double t, Conditions at) const;
  /// Coefficients of friction; empty unless the problem has friction. @throws ModelError as initial_load()
  Friction friction(double t) const;
  /// Weighted distances of the surfaces at t = 0 before loads and interference are applied (n_rows): the given gaps,
  /// with each pair whose surfaces overlap moved apart until they just touch.
  Eigen::VectorXd unloaded_gap() const;
  /// A load with all entries zero.
  InterfaceLoad no_load() const;
  /// Adds the work of the external forces of a body on its rigid-body modes.
  void add_resultant(std::size_t body, const mechanics::BodyConditions& at, InterfaceLoad& load) const;
  /// True in the process that has the dense matrices, and solves the contact problem for all. In the others problem()
  /// has nodes and rigid-body modes, but no flexibilities, and add_trace() and add_multipliers() do nothing.
  bool is_here() const { return team_.rank() == 0; }
  /// gap += B u. @param u  displacement on the free dofs of the body
  void add_gaps(std::size_t body, std::span<const double> u, Eigen::VectorXd& gap) const;
  /// gap += G^T y2. @param y  L^-1 P f on all free dofs of the body
  void add_trace(std::size_t body, std::span<const double> y, Eigen::VectorXd& gap);
  /// The load in the form the contact solver takes. Warns once if, along an unconstrained mode, the loads are out of
  /// balance by more than 1e-8 of the sum of the forces, as on meshes that are not quite symmetric.
  /// @throws ModelError if they are out of balance by more than 1e-4
  ContactLoad contact_load(const InterfaceLoad& load);
  /// @throws ModelError naming the bodies and the motion along which the loads drive them; SlidingOff if the problem
  /// has friction
  [[noreturn]] void report(const UnbalancedLoad& unbalanced, double t) const;
  /// y2 += G lambda. May run for several bodies at once.
  void add_multipliers(std::size_t body, const Eigen::VectorXd& multiplier, std::span<double> y);
  /// displacement (3 n_nodes) += the rigid-body motion of the body. @param rigid  amplitudes, n_motions of the contact
  /// problem
  void add_rigid_motion(std::size_t body, const Eigen::VectorXd& rigid, std::span<double> displacement) const;
  /// forces (3 n_nodes) += nodal forces of the multipliers on a body.
  void add_contact_forces(std::size_t body, const Eigen::VectorXd& multiplier, std::span<double> forces) const;
  /// Largest error bound of the bodies' solvers; 0 if all are direct.
  double error_bound() const;
  /// Bytes that the dense matrices of the interface take, or would take if !is_dense().
  double dense_bytes() const { return dense_bytes_; }
  /// False if the flexibility is an operator, because the dense matrices would exceed the bound.
  bool is_dense() const { return large_ == nullptr; }
  /// Products with F so far, each one forward and one back substitution of all bodies; 0 if is_dense().
  std::int64_t n_products() const;

 private:
  void make_problem();
  void make_rows();
  void condense(std::span<const std::size_t> bodies);
  void solve_for_flexibility(std::size_t body);
  void factorize(std::span<const std::size_t> bodies, Conditions at);
  void make_operator(Conditions at);
  void sum_flexibilities();
  void warn_of_held_overlaps(const InterfaceLoad& load);

  struct Side {
    RowMatrix full_rows;                 // rows.size() x 3 n_nodes
    std::vector<std::int64_t> trailing;  // dofs that the rows touch
    CondensedRows condensed;             // empty if !is_condensed()
  };
  std::span<const mechanics::Body> bodies_;
  std::span<const Pair> pairs_;
  const RigidBodyModes& rigid_body_modes_;
  const Team& team_;
  std::vector<mechanics::FactoredBody> factored_;
  std::vector<Side> sides_;
  std::vector<BodyRows> rows_;
  double dense_bytes_ = 0;
  double condensed_bytes_ = 0;  // of G and L22 of all bodies, among dense_bytes_
  bool is_condensed_ = false;   // onto the trailing dofs of factors
  bool residual_warned_ = false, overlap_warned_ = false;
  ContactProblem problem_;
  std::vector<int> immovable_;  // rows
  std::unique_ptr<FactoredFlexibility> large_;
  std::int64_t earlier_products_ = 0;  // of operators replaced by refactorize()
};

/// Free dofs that contact rows touch, ascending. @param reduced  contact rows on the free dofs
std::vector<std::int64_t> contact_unknowns(const RowMatrix& reduced);

}  // namespace creepcontact::contact
