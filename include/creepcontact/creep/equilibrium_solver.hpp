#pragma once
/// Elastic equilibrium of all bodies in contact for given creep strains: the map (t, creep strain) -> stress whose
/// value the creep rate needs.
///
/// Where the temperature changes the stiffness K(t) in time, the factors are those of K0, the stiffness of an earlier
/// time. With K(t) = s K0 but for a relative rest of at most q (s and q from the moduli at all points), the equilibrium
/// is found by iterating
///   s K0 u' = s K0 u + F(t) - integral B^T sigma(u) + contact forces,   sigma(u) = H(t) (B u - creep - thermal strain)
/// in contact. Each iteration is one elastic solve and takes the error, in the energy norm, down to q times what it
/// was; the projection onto what contact admits never makes it larger. If q exceeds SolverOptions::refactor_change, K0
/// becomes K(t).

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "creepcontact/base/stopwatch.hpp"
#include "creepcontact/contact/condensed_interface.hpp"
#include "creepcontact/contact/solver/contact_solver.hpp"
#include "creepcontact/contact/solver/frozen_system.hpp"
#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/creep/equilibrium.hpp"

namespace creepcontact::creep {

struct SolverOptions {
  bool use_schwarz = true;  ///< else the active-set method
  contact::SchwarzOptions schwarz;
  double dense_limit_mb = contact::CondensedInterface::unbounded;  ///< of the contact zone's dense matrices
  double refactor_change = 0;  ///< of the stiffness, relative, beyond which it is factored anew
  linalg::StiffnessSolverFactory stiffness_solver = linalg::default_stiffness_solver;
};

/// One thread at a time; several solvers may use one assembly side by side.
class EquilibriumSolver {
 public:
  using CreepStrains = std::span<const mechanics::CreepStrainView>;  // one per body

  /// Factorises all bodies at t = 0. @param assembly and watch must outlive the object
  /// @param admit  as that of CondensedInterface
  EquilibriumSolver(const Assembly& assembly, const SolverOptions& options, Stopwatch& watch,
                    const contact::CondensedInterface::Admission& admit = {});
  ~EquilibriumSolver();

  /// Equilibrium at time t for these creep strains: a pure function of its arguments, to the last bit where the
  /// stiffness does not change in time, to 1e-10 of the stress where it does (factors may be made anew in any solve).
  /// @throws SolverError if the contact iteration does not converge; ModelError if a body that contact alone holds
  /// flies off
  /// Cost: one forward and one backward solve per body; several if the stiffness changes in time.
  /// Source: Stankevich (2012), steps 8-11 of the implicit scheme.
  void solve(double t, CreepStrains creep, const History& history, Equilibrium& into);

  /// Change of stress for a change of creep strain with the contact set of an equilibrium frozen. The moduli are its
  /// stiffness_scale times those of the factors, wrong by q at most: strains that cause no stress still cause none, and
  /// a Newton iteration converges linearly with the factor q.
  /// @param stress  one per body, n_points x 6. Cost: one forward and one backward solve per body.
  void linearized(const Equilibrium& at, CreepStrains creep_change, std::vector<std::vector<double>>& stress);

  /// An empty history for this assembly.
  History new_history() const;
  /// The equilibrium of an accepted step becomes the start of the contact iterations to come.
  void accept(const Equilibrium& at, History& history) const;
  /// The history, and what of this solver evaluations depend on, for a checkpoint.
  void save(const History& history, Memory& memory) const;
  /// @throws std::out_of_range if something is missing
  void restore(const Memory& memory, History& history);

  /// Told of every contact iteration from now on. @param recorder must outlive the object
  void set_recorder(contact::IterationRecorder* recorder);

  const Assembly& assembly() const { return assembly_; }
  const contact::CondensedInterface& interface() const { return interface_; }
  /// pass(body) for every body, side by side if the factors are so large that it pays; timed as Part::solve.
  void for_each_factor(const std::function<void(std::size_t)>& pass) const;

  struct Counters {
    std::int64_t elastic_solves = 0, contact_solves = 0, schwarz_iterations = 0, factorizations = 0;
  };
  Counters counters() const;

 private:
  struct Work {
    std::vector<double> right_hand_side, factored, free;  // n_free
    std::vector<double> displacement;                     // 3 n_nodes, of linearized()
    std::vector<double> no_displacement;                  // zeros
  };
  struct StiffnessChange {
    double scale = 1, rest = 0;  // s and q
  };
  EquilibriumSolver(const Assembly& assembly, const SolverOptions& options, Stopwatch& watch,
                    const contact::CondensedInterface::Admission& admit,
                    const std::vector<mechanics::BodyConditions>& at_start);
  std::unique_ptr<contact::ContactSolver> make_contact_solver() const;
  StiffnessChange stiffness_change(const std::vector<mechanics::BodyConditions>& at) const;
  /// Makes K0 the stiffness of these conditions.
  void refactorize(const std::vector<mechanics::BodyConditions>& at);
  /// @returns false if the iteration does not converge, which nothing but rounding can be the cause of
  bool iterate(CreepStrains creep, const History& history, const StiffnessChange& change, Equilibrium& into);
  /// Right-hand sides for the start: from the displacements of the last accepted steps, or from none. @returns the load
  /// without traces
  contact::InterfaceLoad start(CreepStrains creep, const History& history, const StiffnessChange& change,
                               Equilibrium& into);
  /// One elastic solve. @returns change of the displacement, energy norm
  double advance(const contact::InterfaceLoad& given, const contact::ContactState& from, CreepStrains creep,
                 Equilibrium& into);
  /// Displacement and stress of a body with these free unknowns.
  void update_state(std::size_t body, std::span<const double> free, const Eigen::VectorXd& rigid,
                    const mechanics::CreepStrainView& creep, Equilibrium& into) const;
  /// Right-hand sides F(t) - integral B^T sigma of the last iterate.
  void leave_residual(const Equilibrium& of);
  void forward();
  void solve_contact(const contact::InterfaceLoad& load, const contact::ContactState& from, Equilibrium& into);
  void backward(const Eigen::VectorXd& multiplier);

  const Assembly& assembly_;
  SolverOptions options_;
  Stopwatch& watch_;
  contact::CondensedInterface interface_;
  std::unique_ptr<contact::ContactSolver> contact_solver_;
  contact::FrozenSystem frozen_;
  contact::IterationRecorder* recorder_ = nullptr;
  bool stiffness_changes_ = false;
  std::int64_t factors_ = 0;  // number of the factorisation, since the start
  std::vector<Work> work_;    // holds nothing between calls
  bool parallel_passes_ = false;
  Counters counters_;
};

}  // namespace creepcontact::creep
