#pragma once
/// Elastic equilibrium of all bodies in contact for given creep strains: the map (t, creep strain) -> stress whose
/// value the creep rate needs.
///
/// Where the temperature changes the stiffness K(t) in time, the factors are those of K0, the stiffness of an earlier
/// time. With K(t) = s K0 but for a relative rest of at most q (s and q from the moduli at all points), the equilibrium
/// is found by iterating
///   s K0 u' = s K0 u + F(t) - integral B^T sigma(u) + contact forces,   sigma(u) = H(t) (B u - creep - thermal strain)
/// in contact. Each iteration is one elastic solve and takes the error, in the energy norm, down to q times what it
/// was; the projection onto what contact admits never makes it larger. If q exceeds Model::refactor_change, K0 becomes
/// K(t).

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "creepcontact/base/stopwatch.hpp"
#include "creepcontact/contact/solver/frozen_system.hpp"
#include "creepcontact/simulation/contact_log.hpp"
#include "creepcontact/simulation/model.hpp"

namespace creepcontact::simulation {

/// Mechanical state of one body.
struct BodyState {
  std::vector<double> displacement;  ///< 3 n_nodes
  std::vector<double> stress;        ///< n_points x 6, Mandel order
};

class ContactElasticity {
 public:
  using CreepViews = std::vector<mechanics::CreepStrainView>;  // one a body

  /// Factorises all bodies. @param model and watch must outlive the object
  /// @param admit  as that of CondensedInterface
  ContactElasticity(Model& model, Stopwatch& watch, const contact::CondensedInterface::Admission& admit = {});

  /// Equilibrium at time t for these creep strains; a pure function of both, warm-started from keep_warm().
  /// Results below are valid until the next call.
  /// @throws SolverError if the contact iteration does not converge; ModelError if a body that contact alone holds
  /// flies off
  /// Cost: one forward and one backward solve a body; several if the stiffness changes in time.
  /// Source: Stankevich (2012), steps 8-11 of the implicit scheme.
  void solve(double t, const CreepViews& creep);
  const std::vector<BodyState>& states() const { return states_; }
  double time() const { return time_; }  ///< of the last solve
  /// Multipliers (contact pressures) and weighted gaps of all contact rows.
  const Eigen::VectorXd& multipliers() const { return last_.multiplier; }
  const Eigen::VectorXd& gaps() const { return gaps_; }
  std::size_t active_contacts() const { return last_.active.size(); }
  /// Rows in contact, ascending.
  const std::vector<int>& active_set() const { return last_.active; }

  /// Change of stress for a change of creep strain with the contact set of the last solve frozen. The moduli are s
  /// times those of the factors, wrong by q at most: strains that cause no stress still cause none, and a Newton
  /// iteration converges linearly with the factor q.
  /// @param stress  one a body, n_points x 6. Cost: one forward and one backward solve a body.
  void linearized(const CreepViews& creep_change, std::vector<std::vector<double>>& stress);

  /// The last solution becomes the start of the contact iterations to come (call at accepted steps only).
  void keep_warm();
  /// How often a pair's nodes in contact were others after a step than before it, one a pair.
  const std::vector<std::int64_t>& set_changes() const { return set_changes_; }
  /// All that solves to come depend on beside their arguments, for a checkpoint.
  using Memory = std::map<std::string, std::vector<double>>;
  void save(Memory& memory) const;
  /// @throws std::out_of_range if something is missing
  void restore(const Memory& memory);

  /// Writes every contact iteration from now on. @param log must outlive the object
  void log_contact(ContactLog& log);

  const contact::CondensedInterface& interface() const { return interface_; }
  /// s: the stiffness at the time of the last solve over that of the factors.
  double stiffness_scale() const { return stiffness_.scale; }
  /// pass(body) for every body, side by side if the factors are so large that it pays; timed as Part::solve.
  void pass_through_factors(const std::function<void(std::size_t)>& pass) const;
  const Model& model() const { return model_; }

  struct Counters {
    std::int64_t elastic_solves = 0, contact_solves = 0, schwarz_iterations = 0, factorizations = 0;
  };
  Counters counters() const {
    Counters all = counters_;
    all.elastic_solves += interface_.n_products();
    return all;
  }

 private:
  struct Work {
    std::vector<double> right_hand_side, factored, free;  // n_free
    std::vector<double> displacement;                     // 3 n_nodes, of linearized()
    std::vector<double> no_displacement;                  // zeros
  };
  struct StiffnessChange {
    double scale = 1, rest = 0;  // s and q
  };
  /// A displacement u: y = L^T u and u on the free unknowns. No values: u = 0.
  struct Iterate {
    std::vector<double> factored, free;
  };
  struct Kept {
    double time = 0;
    std::vector<Iterate> bodies;
  };
  StiffnessChange stiffness_change() const;
  /// Makes K0 the stiffness of the set time.
  void refactorize();
  /// @returns false if the iteration does not converge, which nothing but rounding can be the cause of
  bool iterate(double t, const CreepViews& creep);
  /// Right-hand sides for the start: from the displacements of the last accepted steps, or from none. @returns the load
  /// without traces
  contact::InterfaceLoad start(double t, const CreepViews& creep);
  /// The iterate becomes what the last two accepted steps lead to.
  void extrapolate(double t);
  /// One elastic solve. @returns change of the displacement, energy norm
  double advance(const contact::InterfaceLoad& given, const contact::ContactState& from, const CreepViews& creep);
  /// Displacement and stress of the last iterate.
  void update_state(std::size_t body, const Eigen::VectorXd& rigid, const mechanics::CreepStrainView& creep);
  /// Right-hand sides F(t) - integral B^T sigma of the last iterate.
  void leave_imbalance();
  /// Energy norms of the last iterate.
  double displacement_norm() const;
  double stress_norm() const;
  /// Right-hand sides through the factors of all bodies, side by side.
  void forward();
  void solve_contact(const contact::InterfaceLoad& load, const contact::ContactState& warm);
  void backward(const Eigen::VectorXd& multiplier);

  Model& model_;
  Stopwatch& watch_;
  contact::CondensedInterface interface_;
  std::unique_ptr<contact::ContactSolver> solver_;
  contact::FrozenSystem frozen_;
  ContactLog* log_ = nullptr;
  bool stiffness_changes_ = false;
  StiffnessChange stiffness_;     // at time_
  std::vector<Iterate> iterate_;  // one a body if the stiffness changes: of the last solve
  std::vector<Kept> kept_;        // of the last two accepted steps, the last one first
  contact::ContactState last_, warm_;
  Eigen::VectorXd gaps_;
  double time_ = 0;
  std::vector<BodyState> states_;
  std::vector<Work> work_;
  bool parallel_passes_ = false;
  Counters counters_;
  std::vector<std::int64_t> set_changes_;
};

}  // namespace creepcontact::simulation
