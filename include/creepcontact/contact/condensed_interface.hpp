#pragma once
/// All contact pairs condensed onto their multipliers. With the contact unknowns eliminated last, K = L L^T, and rows B
/// of a body's weighted gaps, G = L22^-1 B^T holds all that contact needs:
///   y = L^-1 f,   gap = initial gap + G^T y2,   contact forces: y2 += G lambda,   u = L^-T y,   F = G^T G.
/// So contact costs no pass through the factor of its own.
/// Contact zones whose dense matrices would exceed a bound are left in the factor: any ordering, G = L^-1 P B^T applied
/// by passes of its own, F by a forward and a backward pass a product.

#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/body_rows.hpp"
#include "creepcontact/contact/condensed_rows.hpp"
#include "creepcontact/contact/floating_motions.hpp"
#include "creepcontact/contact/solver/problem.hpp"
#include "creepcontact/mechanics/body.hpp"
#include "creepcontact/mechanics/factored_body.hpp"

namespace creepcontact::contact {

/// What the loads ask of contact, gathered body by body.
struct InterfaceLoad {
  Eigen::VectorXd gap;    ///< weighted gaps, n_rows
  Eigen::VectorXd work;   ///< of external forces on unit free motions of all bodies
  Eigen::VectorXd force;  ///< sum of absolute external forces on the body of each motion, to measure the work by
  double time = 0;
};

class FactoredFlexibility;

class CondensedInterface {
 public:
  /// Conditions of all bodies, in their order.
  using Conditions = std::span<const mechanics::BodyConditions>;
  /// Factorises every body with its contact unknowns last. @param bodies, pairs (numbered) and floating (of both) must
  /// outlive the object @param at  whose stiffness is factored
  /// @throws ModelError as FactoredBody::factorize and FloatingMotions::require_contact
  /// Cost: the factorisations, and n_contact^2 x n_rows operations per body.
  /// @param dense_bytes  bound on the dense matrices
  /// @param admit  called between analysis and factorisation, when the sizes of all factors are known and nothing of
  ///        them is taken; it may throw. @param dense_bytes of it: those of the dense matrices that will be made
  using Admission = std::function<void(const CondensedInterface& analyzed, double dense_bytes)>;
  CondensedInterface(std::span<const mechanics::Body> bodies, std::span<const Pair> pairs,
                     const FloatingMotions& floating, Conditions at, double dense_bytes = unbounded,
                     const Admission& admit = {},
                     const linalg::StiffnessSolverFactory& make_solver = linalg::default_stiffness_solver);
  ~CondensedInterface();
  static constexpr double unbounded = std::numeric_limits<double>::infinity();

  /// Factors these bodies anew, with the stiffness of these conditions, and condenses their rows anew. Contact solvers
  /// and systems made of problem() must be told (flexibility_changed). Cost: as the constructor, without the orderings.
  void refactorize(std::span<const std::size_t> bodies, Conditions at);

  std::span<const Pair> pairs() const { return pairs_; }
  mechanics::FactoredBody& factored(std::size_t body) { return factored_[body]; }
  const mechanics::FactoredBody& factored(std::size_t body) const { return factored_[body]; }
  const ContactProblem& problem() const { return problem_; }
  const FloatingMotions& floating() const { return floating_; }
  Index n_rows() const { return problem_.n_rows(); }
  const BodyRows& rows(std::size_t body) const { return rows_[body]; }
  /// Free unknowns that the body's factor eliminates last, those that its rows touch, if is_dense().
  std::span<const std::int64_t> trailing(std::size_t body) const { return sides_[body].trailing; }

  /// Without creep, loads and contact: given gap and prescribed displacements.
  InterfaceLoad initial_load(double t, Conditions at) const;
  InterfaceLoad no_load() const;
  /// Adds the work of the body's external forces on its free motions.
  void add_resultant(std::size_t body, const mechanics::BodyConditions& at, InterfaceLoad& load) const;
  /// gap += G^T y2. @param y  L^-1 P f of the body, all free unknowns
  void add_trace(std::size_t body, std::span<const double> y, Eigen::VectorXd& gap);
  /// The load for the contact solver. Warns once of loads that are out of balance along idle motions by rounding of the
  /// mesh. @throws ModelError if they push bodies along idle motions by more than 1e-4 of their sum
  ContactLoad contact_load(const InterfaceLoad& load);
  /// @throws ModelError that names the bodies and their motion
  [[noreturn]] void report(const UnbalancedLoad& unbalanced, double t) const;
  /// y2 += G lambda
  void add_multipliers(std::size_t body, const Eigen::VectorXd& multiplier, std::span<double> y);
  /// u += the body's rigid motion. @param rigid  amplitudes of the contact problem's motions; displacement 3 n_nodes
  void add_rigid_motion(std::size_t body, const Eigen::VectorXd& rigid, std::span<double> displacement) const;
  /// Nodal forces of the multipliers on a body, 3 n_nodes, added.
  void add_contact_forces(std::size_t body, const Eigen::VectorXd& multiplier, std::span<double> forces) const;
  /// Bytes that the dense interface matrices take or would take.
  double dense_bytes() const { return dense_bytes_; }
  bool is_dense() const { return large_ == nullptr; }
  /// Forward and backward passes through all factors that products with F have cost so far.
  std::int64_t n_products() const;

 private:
  void make_problem();
  void make_rows();
  void condense(std::size_t body);
  void make_operator(Conditions at);
  void sum_flexibilities();
  void warn_of_held_overlaps(const InterfaceLoad& load);

  struct Side {
    RowMatrix full_rows;                 // rows.size() x 3 n_nodes
    std::vector<std::int64_t> trailing;  // unknowns that the rows touch
    CondensedRows condensed;             // empty if large
  };
  std::span<const mechanics::Body> bodies_;
  std::span<const Pair> pairs_;
  const FloatingMotions& floating_;
  std::vector<mechanics::FactoredBody> factored_;
  std::vector<Side> sides_;
  std::vector<BodyRows> rows_;
  double dense_bytes_ = 0;
  bool imbalance_warned_ = false, overlap_warned_ = false;
  ContactProblem problem_;
  std::vector<int> immovable_;  // rows
  std::unique_ptr<FactoredFlexibility> large_;
  std::int64_t earlier_products_ = 0;  // those of a large_ that was replaced
};

/// Free unknowns that contact rows touch, ascending. @param reduced  rows on the free unknowns
std::vector<std::int64_t> contact_unknowns(const RowMatrix& reduced);

}  // namespace creepcontact::contact
