#pragma once
/// Creep of all bodies and gaskets as a differential equation dy/dt = f(t, y). y holds the creep strains and internal
/// variables of all integration points and gasket nodes; f(t, y) holds the rates of the creep laws at the stress of the
/// elastic contact equilibrium.

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/creep/body_laws.hpp"
#include "creepcontact/creep/elastic_survey.hpp"
#include "creepcontact/creep/equilibrium_solver.hpp"
#include "creepcontact/creep/error_scale.hpp"
#include "creepcontact/creep/evaluation.hpp"
#include "creepcontact/creep/last_path.hpp"
#include "creepcontact/creep/material_points.hpp"
#include "creepcontact/creep/material_tangent.hpp"
#include "creepcontact/creep/point_preconditioner.hpp"
#include "creepcontact/creep/relaxation.hpp"
#include "creepcontact/creep/tangent_system.hpp"
#include "creepcontact/creep/yield_steps.hpp"
#include "creepcontact/ode/system.hpp"

namespace creepcontact::creep {

class GasketCreep;
class HeatCoupling;

/// The creep rate as the integrators see it. It is a pure function of (t, y) and the history of accepted steps:
/// evaluations for outputs (evaluate_output) never change what the steps compute. One thread at a time.
class CreepSystem final : public ode::System,
                          public ode::JacobianProducts,
                          public ode::NewtonSolver,
                          public ode::SingularRate {
 public:
  /// @param solver, watch  must outlive the object
  /// @param survey  made with the same solver
  /// @param tolerance  relative tolerance of the integrator: strain hardening below 0.3 of it is not resolved
  /// (PointState::min_strain)
  CreepSystem(EquilibriumSolver& solver, const ElasticSurvey& survey, double tolerance, Stopwatch& watch);
  ~CreepSystem() override;

  std::size_t size() const override { return laws_.layout().size(); }
  /// The state at t = 0: no creep; temperatures, if they are part of the state. Steady ones are found with the contact
  /// that belongs to them. @throws SolverError without convergence
  std::vector<double> initial_state();
  /// The part of a change of temperatures that comes back through contact, see io::Summary::Heat; nullopt without heat
  /// in the state, or where nothing holds temperatures. Cost: some elastic solves
  std::optional<double> loop_gain(double t, std::span<const double> y);
  const Team& team() const override { return assembly().team(); }
  /// @throws RecoverableError if no equilibrium is found, or if the stress or a rate is not finite
  void rate(double t, std::span<const double> y, std::span<double> rate) override;
  /// J v = C H (B du - v) + (coupling to the internal variables), where K du = B^T H v with the closed contacts held
  /// closed, and C = d(rate)/d(stress). Cost: as an elastic solve.
  void jacobian_times(double t, std::span<const double> y, std::span<const double> v,
                      std::span<double> product) override;
  void prepare_preconditioner(double t, std::span<const double> y) override;
  void precondition(double gamma, std::span<const double> r, std::span<double> z) override;
  void precondition_once(double t, std::span<const double> y, double gamma, std::span<const double> r,
                         std::span<double> z) override;
  ode::JacobianProducts* jacobian() override { return this; }
  /// Null unless contact is condensed to dense matrices, and one process has all of them.
  ode::NewtonSolver* newton_solver() override {
    return solver_.interface().is_condensed() && team().size() == 1 && !heat_ ? this : nullptr;
  }
  /// Null unless some law may start with an infinite rate (ElasticSurvey::singular_start).
  ode::SingularRate* singular_rate() override { return may_start_singular_ ? this : nullptr; }
  void prepare_tangent(double t, std::span<const double> y, double gamma) override;
  void solve_tangent(std::span<const double> r, std::span<double> z) override;
  double stable_step(double t, std::span<const double> y) override;
  double end_of_segment() const override { return segment_end_; }
  double start_exponent(double t, std::span<const double> y) override;
  void start_increment(double t, std::span<const double> y, double stress_time, double duration,
                       std::span<double> change) override;
  /// Typical stress / Young's modulus per body (ErrorScale); it follows the stress of the accepted steps.
  std::span<const double> scale() const override { return scale_.values(); }
  /// scale() for errors that do not repeat in every cycle of the loads.
  std::vector<double> scale_of_whole_run() const { return scale_.of_whole_run(); }
  /// See ErrorScale::resolve_cycle().
  void resolve_cycle(std::span<const double> change, double least) { scale_.resolve_cycle(change, least); }
  /// Applies the preloads that are due at t, and takes slip and plastic flow of loads that jump there into the history.
  /// Call it before the first evaluation after t. @throws as EquilibriumSolver::apply_preloads
  void pass_breakpoint(double t, std::span<const double> y);
  /// What the points of the bodies that may yield have from their flow, in turn: plastic strains, accumulated strain,
  /// alpha_i. Empty if nothing may yield.
  std::vector<double> flow() const;
  /// Sets flow(), for a state that is not the one of the last step. Call settle_flow() with that state.
  void set_flow(std::span<const double> flow);
  /// Takes into the history what flows at (t, y), the stress there, and the creep strain. It does so once more if a run
  /// changes its state other than by a step.
  void settle_flow(double t, std::span<const double> y);
  /// scale_of_whole_run() for flow().
  std::vector<double> scale_of_flow() const;
  /// Makes the last step evaluation part of the history. It may have been made close to the accepted point; with
  /// friction or yielding, whose slip and plastic strain it defines, it is made again unless it is within a tenth of
  /// the tolerance. The path of slip and flow is followed (EquilibriumSolver::accept), and evaluations at (t, y) are
  /// those of its end.
  void accept(double t, std::span<const double> y) override;
  bool rate_has_jumped() const override { return rate_has_jumped_; }
  void forget_evaluations() override;
  ode::System::Counters counters() const override { return {rate_evaluations_, jacobian_products_}; }
  /// All work so far except the integrator's: no steps.
  RunCounters run_counters() const;
  /// Closed multiplier nodes at the last evaluation of a step.
  std::int64_t n_active_contacts() const { return std::ssize(step_.equilibrium.contact.active); }

  /// Restricts the time at which loads, supports, gaps and temperatures are evaluated to the open interval (begin,
  /// end). Jumps at its two ends then give the one-sided limits from within.
  void begin_segment(double begin, double end);
  double begin_of_segment() const { return segment_begin_; }

  /// The evaluation at (t, y) for results; valid until the next call of a non-const member. Reuses an evaluation made
  /// for a step at the same point. @throws RecoverableError if no equilibrium is found
  const Evaluation& evaluate_output(double t, std::span<const double> y);
  /// evaluate_output() for the results of a run, in the order of their times: with friction, accumulated slip and
  /// dissipated energy do not fall from one to the next.
  const Evaluation& evaluate_result(double t, std::span<const double> y);
  /// The evaluation at (t, y) for steps: reused if the last one was at the same point, else solved.
  /// @throws RecoverableError if no equilibrium is found
  /// @param carried  as EquilibriumSolver::solve(); not made if nothing is solved
  const Evaluation& evaluate_step(double t, std::span<const double> y, const CarriedChanges* carried = nullptr);
  /// The rate in the state of an evaluation, which makes it no evaluation for steps. Cost: of the laws
  std::vector<double> rate_of(const Evaluation& at) const;
  /// How much the rate would differ at another time in the state y that was accepted at `from`: the largest component
  /// over the error that a step may make in it [1/time]; infinity if there is no equilibrium. Collective.
  /// Cost: one elastic solve.
  double rate_change(double from, std::span<const double> y, double t);
  /// The evaluation at the end of the last accepted step: the one that the step has made at t, on y or within the
  /// tolerance of it; solved only where the step has made none there, and then what the next step begins with.
  /// @throws RecoverableError if no equilibrium is found
  const Evaluation& evaluate_accepted(double t, std::span<const double> y);
  /// The last evaluation made for a step.
  const Evaluation& step_evaluation() const { return step_; }
  /// Shortest relaxation time per body, 1 / (largest eigenvalue of C H over its points); infinity if nothing creeps.
  /// Collective.
  std::vector<double> relaxation_times(const Evaluation& at) const;
  /// Times in which the bodies would relax at the stress of an evaluation at t = 0, from its creep at constant stress;
  /// nullopt for elastic bodies. @param near  see relaxation_time() Collective.
  std::vector<std::optional<RelaxationTime>> initial_relaxation(const Evaluation& at, double near) const;

  /// Stores what later evaluations depend on in addition to their arguments: the history and the error scale.
  void save(Memory& memory) const;
  /// @throws std::out_of_range if an entry is missing
  void restore(const Memory& memory);
  const History& history() const { return history_; }
  bool has_friction() const { return history_.friction.slip.size() > 0; }
  bool has_gaskets() const { return history_.gaskets.largest.size() > 0; }
  bool has_yielding() const { return !history_.plastic.bodies.empty(); }
  /// True if states depend on the accepted ones before them, beyond what the differential equation has of them.
  bool depends_on_path() const { return has_friction() || has_yielding() || has_gaskets(); }
  /// Sets the state from which the integration continues. Call it after restore() and begin_segment(), with that
  /// memory.
  /// @throws RecoverableError if no equilibrium is found
  void resume(double t, std::span<const double> y, const Memory& memory);
  /// Longest next step from t for which no yielding is missed (YieldSteps; with plasticity the loads change the stress
  /// by a tenth of the yield stress) and, with friction, the stiffness changes little; infinity if nothing bounds it.
  /// @param y  the state at t
  double longest_step(double t, std::span<const double> y);
  /// The part of that for friction. @param end  the farthest that is of interest
  double longest_step_of_friction(double t, double end) const {
    return solver_.longest_for_friction(load_time(t), load_time(end));
  }

  const EquilibriumSolver& solver() const { return solver_; }
  const Assembly& assembly() const { return solver_.assembly(); }
  const BodyLaws& laws() const { return laws_; }
  const StateLayout& layout() const { return laws_.layout(); }

  /// True if some law of some body has this variable (damage, life fraction, ...).
  bool has(const material::StateVariable& variable) const { return laws_.has(variable); }
  struct Extreme {
    double value = 0;
    std::size_t body = 0;
    Vector3 position = Vector3::Zero();
  };
  /// Largest value over all points of a body; nullopt if none of its laws has the variable. Collective.
  /// @param scalar  not a tensor
  /// @param y  the state, equal or close to that of `at`
  std::optional<Extreme> largest(const material::StateVariable& scalar, std::size_t body, const Evaluation& at,
                                 std::span<const double> y) const;

 private:
  void solve(double t, std::span<const double> y, Evaluation& into, const CarriedChanges* carried = nullptr);
  /// The creep strains in y, or in a change of it; valid until the next call.
  CreepStrains strains(std::span<const double> y);
  /// Creep strains and temperatures of a state at time t.
  CreepStrains strains(double t, std::span<const double> y);
  /// What the gaskets are preconditioned with: F + compliance per row.
  Eigen::VectorXd gasket_flexibility() const;
  bool is_at(double t, std::span<const double> y, const Evaluation& of) const;
  bool is_near(double t, std::span<const double> y, const Evaluation& of) const;
  /// The time at which the loads are evaluated for t: t moved inside the segment of begin_segment().
  double load_time(double t) const;
  void resize_tangents();
  /// Products with what temperatures change: the strains and the rates of the laws, and the rates of temperatures.
  void heat_products(const Evaluation& at, std::span<const double> y, std::span<const double> v,
                     std::span<double> product);
  /// The tangents at step_.
  const std::vector<std::vector<material::StressTangent>>& step_tangents();
  /// @param before  the history before preloads of t @returns true if something flows
  bool settle_flow(double t, std::span<const double> y, const History& before);
  double excursion_at_end(std::span<const double> y);
  double smallest_start_exponent(double t, const Evaluation& at) const;
  std::string describe_overflow(const Evaluation& at, std::span<const double> rate) const;

  EquilibriumSolver& solver_;
  Stopwatch& watch_;
  ErrorScale scale_;
  BodyLaws laws_;
  std::optional<TangentSystem> tangent_;  // made at first use
  std::vector<PointPreconditioner> preconditioners_;
  /// The point-wise part of the Newton systems of bodies with internal variables, made with local_gamma_.
  std::vector<std::unique_ptr<MaterialTangent>> local_;
  double local_gamma_ = 0;        // 0: not prepared
  bool tangents_needed_ = false;  // since the last rate: so they may be computed with the next one
  bool may_start_singular_ = false;
  double segment_begin_ = -std::numeric_limits<double>::infinity();
  double segment_end_ = std::numeric_limits<double>::infinity();
  double tolerance_;
  YieldSteps yield_steps_;
  History history_;
  LastPath path_;  // with friction or flow: what happens within the last step starts from there
  ReportedSlip reported_;
  bool rate_has_jumped_ = false;  // in the last accept()
  Evaluation step_, output_;      // each identified by its (time, y)
  std::vector<mechanics::CreepStrainView> views_;
  std::unique_ptr<GasketCreep> gaskets_;
  std::vector<double> closures_;
  std::unique_ptr<HeatCoupling> heat_;             // null: the temperature is not part of the state
  std::vector<std::vector<double>> temperatures_;  // at the points, of strains()
  std::vector<Eigen::MatrixXd> gasket_jacobians_;  // of prepare_preconditioner()
  std::vector<std::vector<double>> stress_change_;
  std::int64_t rate_evaluations_ = 0, jacobian_products_ = 0;
};

}  // namespace creepcontact::creep
