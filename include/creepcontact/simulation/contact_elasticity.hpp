#pragma once
/// Elastic equilibrium of all bodies in contact for given creep strains: the map (t, creep strain) -> stress whose
/// value the creep rate needs.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "creepcontact/base/stopwatch.hpp"
#include "creepcontact/contact/frozen_system.hpp"
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
  ContactElasticity(Model& model, Stopwatch& watch);

  /// Equilibrium at time t for these creep strains; a pure function of both, contact warm-started from keep_warm().
  /// Results below are valid until the next call.
  /// @throws SolverError if the contact iteration does not converge; ModelError if a body that contact alone holds
  /// flies off
  /// Cost: one forward and one backward solve a body.
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

  /// Change of stress for a change of creep strain with the contact set of the last solve frozen.
  /// @param stress  one a body, n_points x 6. Cost: as solve().
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
  /// Right-hand sides through the factors of all bodies, side by side. @returns the load with their traces
  contact::InterfaceLoad forward(contact::InterfaceLoad load);
  void solve_contact(double t, const contact::ContactLoad& load);
  void backward(const Eigen::VectorXd& multiplier);

  Model& model_;
  Stopwatch& watch_;
  contact::CondensedInterface interface_;
  std::unique_ptr<contact::ContactSolver> solver_;
  contact::FrozenSystem frozen_;
  ContactLog* log_ = nullptr;
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
