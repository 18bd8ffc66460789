#pragma once
/// Elastic equilibrium of all bodies in contact for given creep strains: the map (t, creep strain) -> stress that the
/// creep rate needs.
///
/// Where the temperature changes the stiffness K(t) in time, the factors belong to K0, the stiffness of an earlier
/// time. Let s be the scale factor for which K(t) = s K0 up to a relative deviation q (s and q follow from the moduli
/// at all points). The equilibrium is then found by iterating
///   s K0 u' = s K0 u + F(t) - integral B^T sigma(u) + contact forces,   sigma(u) = H(t) (B u - creep - thermal strain)
/// with contact solved in each iteration. An iteration costs one elastic solve and reduces the error in the energy norm
/// by the factor q; the projection onto the admissible contact states never increases it. If q exceeds
/// SolverOptions::refactor_change, K(t) is factored and becomes K0.
/// A solver that is not direct only approximates K0^-1. Its error bound e (StiffnessSolver::error_bound) adds to q, and
/// the same iteration ends when the error of the stress is below SolverOptions::stress_tolerance.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "creepcontact/base/run_counters.hpp"
#include "creepcontact/base/stop_request.hpp"
#include "creepcontact/base/stopwatch.hpp"
#include "creepcontact/contact/condensed_interface.hpp"
#include "creepcontact/contact/solver/active_set_system.hpp"
#include "creepcontact/contact/solver/contact_solver.hpp"
#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/creep/equilibrium.hpp"
#include "creepcontact/creep/equilibrium_change.hpp"

namespace creepcontact::creep {

class FrictionFollower;
class SlipAdvance;
struct StiffnessChange;

/// Options of an EquilibriumSolver.
struct SolverOptions {
  bool use_schwarz = true;  ///< false: active-set method
  contact::SchwarzOptions schwarz;
  double dense_limit_mb = contact::CondensedInterface::unbounded;  ///< bound on dense contact matrices [MB]
  settings::FrictionMethod friction = settings::ContactSettings{}.friction;
  int initial_substeps = settings::ContactSettings{}.initial_substeps;  ///< with friction, see initial_history()
  double refactor_change = 0;       ///< largest q (see above) before the stiffness is factored again
  double stress_tolerance = 1e-10;  ///< error of the iteration relative to the stress in the body, energy norm
  double plastic_tolerance = 1e-6;  ///< likewise of the plastic strain: the change of the stress in an iteration
  linalg::StiffnessSolverFactory stiffness_solver = linalg::default_stiffness_solver;
};

/// Solves the elastic contact problem of an assembly. Use from one thread at a time; several solvers may share one
/// assembly concurrently.
class EquilibriumSolver {
 public:
  using CreepStrains = creep::CreepStrains;

  /// Factors all bodies at t = 0. @param assembly, watch  must outlive the object
  /// @param admit  see CondensedInterface @throws ModelError as the constructor of CondensedInterface
  EquilibriumSolver(const Assembly& assembly, const SolverOptions& options, Stopwatch& watch,
                    const contact::CondensedInterface::Admission& admit = {});
  ~EquilibriumSolver();

  /// Equilibrium at time t for these creep strains. A pure function of its arguments: to the last
  /// bit if the stiffness is constant in time, the solver direct, and nothing yields. Otherwise to the tolerances.
  /// @throws SolverError if the contact iteration does not converge; ModelError if the loads push away a body that only
  /// contact holds, or drive an unconstrained motion
  /// Cost: one forward and one back substitution per body; several if the stiffness changes, the solver is not direct,
  /// or points yield (PlasticFlow). Source: Stankevich (2012), steps 8-11 of the implicit scheme.
  /// @param carried  changes() of the same equilibrium, of a model that is_piecewise_linear(); or null
  void solve(double t, CreepStrains creep, const History& history, Equilibrium& into,
             const CarriedChanges* carried = nullptr);

  /// How far the loads of t would change the stress beyond yielding if creep and plastic strains stayed as they are:
  /// the largest change of the equivalent stress since the last accepted step, relative to the yield stress; 0 if
  /// nothing yields. Cost: as solve() without yielding
  double yielding_excursion(double t, CreepStrains creep, const History& history);

  /// Change of stress for a change of creep strain, with the closed contacts of an equilibrium held closed. Uses the
  /// moduli of the factors times stiffness_scale, with a relative error of at most q. Strains that cause no stress
  /// still cause none, and a Newton iteration converges linearly with the factor q. Points that flow go on to
  /// (PlasticTangent).
  /// @param stress  one per body, n_points x 6 @param gap  if not null: the change of the weighted gaps of all rows,
  /// without that by flow @returns the change of the multipliers, without that by flow
  /// Cost: one forward and one back substitution per body; some more where points flow
  Eigen::VectorXd linearized(const Equilibrium& at, CreepStrains creep_change, std::vector<std::vector<double>>& stress,
                             Eigen::VectorXd* gap = nullptr);

  /// Changes of an equilibrium for changes of its equations, to first order: its closed rows stay closed. All of them
  /// share their passes. @param at  of a model that is_piecewise_linear()
  /// @throws SolverError as ActiveSetSystem::solve()
  /// Cost: a forward and a back substitution per body for all of them, and an element loop for each
  void changes(const Equilibrium& at, std::span<const ChangeTask> tasks);
  /// Whether an equilibrium depends on loads and strains alone, and is linear in them while its set of closed rows is
  /// the same: no friction, no gaskets, no yielding, a direct solver, and a stiffness that is constant in time.
  bool is_piecewise_linear() const;

  /// An empty history for this assembly, in which nothing yields.
  History new_history() const;
  /// The history at t = 0, with the preloads of that time and the plastic strain of the first load. With friction or
  /// yielding: loads, prescribed displacements and temperatures of t = 0 are applied in SolverOptions::initial_substeps
  /// proportional steps, and interference is built up by moving the surfaces of the pair uniformly into each other;
  /// preloads grow in proportion. Nothing creeps meanwhile.
  /// @throws as solve() Cost: with friction one forward pass, and one contact problem per substep
  History initial_history() { return initial_history(options_.initial_substeps); }
  /// initial_history() with another number of substeps, at least 1: the difference shows how well the load path is
  /// resolved.
  History initial_history(int substeps);
  /// initial_history() if nothing yielded, whatever the stress.
  History initial_elastic_history() { return initial_elastic_history(options_.initial_substeps); }
  History initial_elastic_history(int substeps);
  /// True if preloads, or pairs that hold what is reached, are due at t and not yet applied.
  bool has_preload_due(double t, const History& history) const;
  /// Finds the interferences with which the preloads that are due at t have their forces, under the loads at `at` and
  /// these creep strains, and keeps them in the history. Interferences found before do not change. Before that, finds
  /// what is reached just before t by the pairs that hold it from t on. Where something yields see pass_jump().
  /// @throws as solve(); ModelError naming the largest force if a force cannot be reached
  /// Cost: some solves, no factorisation
  void apply_preloads(double t, double at, CreepStrains creep, History& history);
  /// The history after loads that jump at t, and preloads that are due there, have made points flow: both grow in
  /// SolverOptions::initial_substeps proportional steps from what acts at the end of the history to what acts at `at`.
  /// @throws as apply_preloads() Cost: as that many solves, which flow
  void pass_jump(double t, double at, CreepStrains creep, History& history);
  /// Makes the equilibrium of an accepted step the start of later contact iterations. With friction the path of slip
  /// from the history to there is followed in substeps, along the course of the gaps that the loads open, and its end
  /// becomes the history. Where points flow and the error of their return is too large, the step is repeated in up to
  /// eight parts, between which the creep strain is linear.
  /// @param at  solved from this history with these creep strains
  /// @returns with friction or flow the path: one leg with at most two points if the step is the path; else nothing
  /// @throws SlidingOff if friction cannot hold a body on the way, after which nothing has changed
  /// Cost: with friction contact solves; some forward substitutions if the loads are not linear in time; parts of a
  /// step cost as solve()
  std::vector<PathLeg> accept(const Equilibrium& at, CreepStrains creep, History& history,
                              const PathOptions& options = {});
  /// The history at an equilibrium in which nothing flows, where a run goes on from another state than that of its last
  /// step: contact is left as it is.
  void settle(const Equilibrium& at, CreepStrains creep, History& history) const;
  /// The longest step from t, up to `end`, with friction and a stiffness that changes in time, in which it changes by
  /// no more than a hundredth, since the path of a step has one flexibility. Else infinity. Collective.
  double longest_for_friction(double t, double end) const;
  /// Stores the history and the state of this solver that evaluations depend on, for a checkpoint.
  void save(const History& history, Memory& memory) const;
  /// Inverse of save(); factors again if the stiffness changes in time. @throws std::out_of_range if an entry is
  /// missing
  void restore(const Memory& memory, History& history);

  /// Reports every contact iteration from now on. @param recorder  null for none; must outlive the object
  void set_recorder(contact::IterationRecorder* recorder);
  /// Sets the request that all later contact iterations heed: whatever solves then throws Cancelled, on all processes,
  /// and leaves the history as it was.
  void set_stop(const StopRequest& stop);

  const Assembly& assembly() const { return assembly_; }
  const contact::CondensedInterface& interface() const { return interface_; }

  /// Elastic solves, contact solves, Schwarz iterations and factorisations since construction.
  RunCounters counters() const;

 private:
  struct Work {
    std::vector<double> right_hand_side, factored, free;  // n_free
    std::vector<double> displacement;                     // 3 n_nodes, of linearized()
    std::vector<double> no_displacement;                  // zeros
  };
  EquilibriumSolver(const Assembly& assembly, const SolverOptions& options, Stopwatch& watch,
                    const contact::CondensedInterface::Admission& admit,
                    const std::vector<mechanics::BodyConditions>& at_start);
  std::unique_ptr<contact::ContactSolver> make_contact_solver() const;
  std::unique_ptr<contact::ContactSolver> make_contact_solver(const contact::ContactProblem& problem) const;
  /// Laws of the gaskets, for pressures on the stiffness of the factors.
  std::vector<contact::ClosureCurve> gasket_curves(double t, const History& history, double stiffness_scale) const;
  std::unique_ptr<FrictionFollower> make_friction_follower();
  /// Factors the stiffness of these conditions, which becomes K0.
  void refactorize(const std::vector<mechanics::BodyConditions>& at);
  /// Loads that grow in steps: what the gaps of contacts were before, and how much of their change acts.
  struct Growth {
    double part = 1;
    Eigen::VectorXd gaps = {};  // before; empty if all of it acts
  };
  /// The equilibrium under the conditions of `into`. Nothing yields. @param from  start of the contact iteration
  void equilibrate(CreepStrains creep, const History& history, const contact::ContactState& from, const Growth& growth,
                   Equilibrium& into, const CarriedChanges* carried = nullptr);
  /// equilibrate() with the plastic strains that belong to it, where the history has some.
  void equilibrate_yielding(CreepStrains creep, const History& history, const Growth& growth, Equilibrium& into,
                            const CarriedChanges* carried = nullptr);
  /// @returns false if the iteration stalls before it converges, which only round-off can cause
  bool iterate(CreepStrains creep, const History& history, const contact::ContactState& begin, const Growth& growth,
               const StiffnessChange& change, Equilibrium& into, const CarriedChanges* carried = nullptr);
  /// Right-hand sides of the first iteration, which starts from the displacements extrapolated from the last accepted
  /// steps, or from zero. @returns the load without the gaps that the right-hand sides open
  contact::InterfaceLoad start(CreepStrains creep, const History& history, const Growth& growth,
                               const StiffnessChange& change, Equilibrium& into);
  /// Lets loads and preloads grow where something yields. @param from, begin, gaps  conditions, time and gaps before
  /// @param at  those after, and their time @param substeps  at least
  void grow(const std::vector<mechanics::BodyConditions>& from, double begin, const Eigen::VectorXd& gaps,
            Equilibrium& at, const std::vector<std::size_t>& preloads, int substeps, CreepStrains creep,
            History& history);
  /// Solves with `part` of the forces of these preloads, and takes contact and slip of what is found into the history.
  /// @param solve  sets `at` to the equilibrium of a history
  void take_part(double part, const std::vector<std::size_t>& preloads,
                 const std::function<const Equilibrium&(const History&)>& solve, const Equilibrium& at,
                 History& history);
  /// The estimated error of the return in the step to `at`, as PlasticHistory::error; nullopt in the first since a
  /// kink.
  std::optional<double> return_error(const Equilibrium& at, const History& history) const;
  /// Makes the flow of an equilibrium part of the history. @param error  return_error()
  void keep_flow(const Equilibrium& at, CreepStrains creep, std::optional<double> error, History& history) const;
  /// The step as one: nothing of it is followed but friction. @param error  return_error()
  /// @returns as FrictionFollower::follow()
  std::vector<PathPoint> take(const Equilibrium& at, CreepStrains creep, std::optional<double> error, History& history,
                              const PathOptions& options);
  /// A step in parts, and the history at its end.
  struct FlowPath {
    std::vector<PathLeg> legs;  ///< empty: one of them cannot be solved
    History end;
  };
  FlowPath in_parts(int n, const Equilibrium& at, CreepStrains creep, const History& from, const PathOptions& options);
  /// A step that flows, in as many parts as its return needs; no legs: it is good as it is. @param error  of it
  FlowPath follow_flow(const Equilibrium& at, CreepStrains creep, std::optional<double> error, const History& from,
                       const PathOptions& options);
  /// linearized() of elastic bodies.
  Eigen::VectorXd linearized_elastic(const Equilibrium& at, CreepStrains creep_change,
                                     std::vector<std::vector<double>>& stress, Eigen::VectorXd* gap = nullptr);
  /// Sets the space of the results.
  void resize(Equilibrium& into) const;
  /// One elastic solve. @returns change of the displacement in the energy norm
  double advance(const contact::InterfaceLoad& given, const contact::ContactState& from, CreepStrains creep,
                 Equilibrium& into, const CarriedChanges* carried);
  /// Displacement and stress of a body from its free dofs.
  void update_state(std::size_t body, std::span<const double> free, const Eigen::VectorXd& rigid,
                    const mechanics::CreepStrainView& creep, Equilibrium& into) const;
  /// Whether one elastic solve may leave an error.
  bool iterates() const { return stiffness_changes_ || solver_error_ > 0; }
  /// Sets the right-hand sides to the residual F(t) - integral B^T sigma of the last iterate.
  void compute_residual(const Equilibrium& of);
  /// Slip up to an equilibrium that was solved from this history.
  SlipHistory slip_until(const Equilibrium& at, const History& history) const;
  /// The pairs whose preloads are due at t.
  std::vector<std::size_t> preloads_due(double t, const History& history) const;
  void hold_what_is_reached(double t, CreepStrains creep, History& history);
  /// Sets the interference of these pairs so that `part` of their forces acts.
  /// @param solve  finds the equilibrium for the interferences of a history
  void find_interference(const std::vector<std::size_t>& pairs, double part, History& history,
                         const std::function<const Equilibrium&(const History&)>& solve);
  /// Weighted gaps of all rows at t without displacements.
  Eigen::VectorXd initial_gaps(double t) const;
  /// Weighted gaps of all rows from the interferences of preloads.
  Eigen::VectorXd interference_gaps(const std::vector<double>& interference) const;
  /// @param with  changes, which make the same pass
  void forward(std::span<const ChangeTask> with = {});
  /// Energy norm of the displacements that backward() left, for the right-hand sides and these multipliers.
  double change_norm(const Eigen::VectorXd& multiplier) const;
  /// gap += the traces of the displacements that forward() left in terms of the factors.
  void add_traces(Eigen::VectorXd& gap);
  /// The change of contact with these gaps while what is closed stays closed.
  contact::ContactState contact_change(const contact::ContactState& at, const Eigen::VectorXd& gap);
  void solve_contact(const contact::InterfaceLoad& load, const contact::ContactState& from, Equilibrium& into);
  void backward(const Eigen::VectorXd& multiplier, std::span<const ChangeTask> with = {});
  // The parts of changes(), between passes.
  /// For each body the forces of all changes.
  std::vector<linalg::SeveralSubstitutions> passes_of(std::span<const ChangeTask> tasks);
  void clear_fixing_dofs(std::span<const ChangeTask> tasks) const;
  /// Contact, between the passes. @param active  closed rows
  void close_changes(const std::vector<int>& active, std::span<const ChangeTask> tasks);
  /// Displacements and stresses, after the passes.
  void finish_changes(std::span<const ChangeTask> tasks);

  const Assembly& assembly_;
  SolverOptions options_;
  Stopwatch& watch_;
  contact::CondensedInterface interface_;
  std::unique_ptr<contact::ContactSolver> contact_solver_;
  contact::ActiveSetSystem active_set_;
  std::unique_ptr<const SlipAdvance> slip_advance_;
  std::unique_ptr<FrictionFollower> friction_;
  contact::IterationRecorder* recorder_ = nullptr;
  StopRequest stop_;
  const bool stiffness_changes_;
  double solver_error_ = 0;                               // its bound
  std::int64_t factors_ = 0;                              // number of factorisations since the start
  std::vector<std::vector<double>> factor_temperatures_;  // at the points, of temperatures that belong to the state
  std::vector<Work> work_;                                // scratch, no state between calls
  RunCounters counters_;
};

}  // namespace creepcontact::creep
