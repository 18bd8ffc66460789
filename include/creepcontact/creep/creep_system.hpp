#pragma once
/// Creep of all bodies as a differential equation: y = creep strains and internal variables of every integration point,
/// f(t, y) = the laws' rates at the stress of the elastic contact equilibrium.

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/creep/elastic_survey.hpp"
#include "creepcontact/creep/equilibrium_solver.hpp"
#include "creepcontact/creep/error_scale.hpp"
#include "creepcontact/creep/material_points.hpp"
#include "creepcontact/creep/material_tangent.hpp"
#include "creepcontact/creep/point_preconditioner.hpp"
#include "creepcontact/creep/state_layout.hpp"
#include "creepcontact/creep/tangent_system.hpp"
#include "creepcontact/ode/system.hpp"

namespace creepcontact::creep {

/// The equilibrium of a state (t, y) and the parameters of the laws there.
struct Evaluation {
  double time = 0;        ///< at which loads were taken
  std::vector<double> y;  ///< the state
  Equilibrium equilibrium;
  std::vector<LawParameters> laws;  ///< one per body
  bool valid = false;
};

/// All work so far, for reports.
struct RunCounters {
  std::int64_t rate_evaluations = 0;
  std::int64_t jacobian_products = 0;
  std::int64_t elastic_solves = 0;
  std::int64_t contact_solves = 0;
  std::int64_t schwarz_iterations = 0;
  std::int64_t factorizations = 0;
  std::int64_t active_contacts = 0;  ///< at the last evaluation
};

/// The rate is a pure function of (t, y) and of the history of accepted steps. Evaluations for outputs
/// (evaluate_output) change nothing that steps see.
class CreepSystem final : public ode::System,
                          public ode::JacobianProducts,
                          public ode::NewtonSolver,
                          public ode::SingularRate {
 public:
  /// @param solver, watch must outlive the object
  /// @param survey  of the same solver
  /// @param tolerance  that the integrator will keep: hardening below it is not resolved
  CreepSystem(EquilibriumSolver& solver, const ElasticSurvey& survey, double tolerance, Stopwatch& watch);
  ~CreepSystem() override;

  std::size_t size() const override { return layout_.size(); }
  const Team& team() const override { return assembly().team(); }
  void rate(double t, std::span<const double> y, std::span<double> rate) override;
  /// J v = C H (B du - v) + (internal couplings), K du = B^T H v with the contact set frozen.
  void jacobian_times(double t, std::span<const double> y, std::span<const double> v,
                      std::span<double> product) override;
  void prepare_preconditioner(double t, std::span<const double> y) override;
  void precondition(double gamma, std::span<const double> r, std::span<double> z) override;
  ode::JacobianProducts* jacobian() override { return this; }
  /// Only where contact is condensed to dense matrices.
  ode::NewtonSolver* newton_solver() override { return solver_.interface().is_dense() ? this : nullptr; }
  ode::SingularRate* singular_rate() override { return may_start_singular_ ? this : nullptr; }
  void prepare_tangent(double t, std::span<const double> y, double gamma) override;
  void solve_tangent(std::span<const double> r, std::span<double> z) override;
  double stable_step(double t, std::span<const double> y) override;
  double start_exponent(double t, std::span<const double> y) override;
  void start_increment(double t, std::span<const double> y, double stress_time, double duration,
                       std::span<double> change) override;
  /// Follows the stress of the accepted steps: typical stress / Young's modulus.
  std::span<const double> scale() const override { return scale_.values(); }
  /// The last evaluation of the steps, which is at or beside the accepted point, becomes part of the history.
  void accept(double t, std::span<const double> y) override;
  void forget_evaluations() override;
  ode::System::Counters counters() const override { return {rate_evaluations_, jacobian_products_}; }
  RunCounters run_counters() const;

  /// Loads, supports, gaps and temperatures may jump at both ends of the time from `begin` to `end`: from now on
  /// they are, at these times, their limits from within.
  void begin_segment(double begin, double end);

  /// For results; valid until the next call. Evaluations of the steps at the same point serve both.
  /// @throws RecoverableError if no equilibrium is found
  const Evaluation& evaluate_output(double t, std::span<const double> y);
  /// For steps: solved, or kept from an evaluation at the same point.
  const Evaluation& evaluate_step(double t, std::span<const double> y);
  /// The last one of the steps.
  const Evaluation& step_evaluation() const { return step_; }
  /// Shortest of every body: 1 / largest eigenvalue of C H; infinity where nothing creeps.
  std::vector<double> relaxation_times(const Evaluation& at) const;

  /// What evaluations to come depend on besides their arguments, for a checkpoint.
  void save(Memory& memory) const;
  /// @throws std::out_of_range if something is missing
  void restore(const Memory& memory);
  const History& history() const { return history_; }

  const EquilibriumSolver& solver() const { return solver_; }
  const Assembly& assembly() const { return solver_.assembly(); }
  const StateLayout& layout() const { return layout_; }

  bool knows(material::Measure measure) const;
  struct Extreme {
    double value = 0;
    std::size_t body = 0;
    Vector3 place = Vector3::Zero();
  };
  /// Largest value of a body, if one of its laws knows the measure. @param y  the state, at or beside that of `at`
  std::optional<Extreme> largest(material::Measure measure, std::size_t body, const Evaluation& at,
                                 std::span<const double> y) const;
  /// Of every point of a body; empty if none of its laws knows the measure.
  std::vector<double> measure(material::Measure of, std::size_t body, const Evaluation& at,
                              std::span<const double> y) const;

 private:
  void solve(double t, std::span<const double> y, Evaluation& into);
  bool is_at(double t, std::span<const double> y, const Evaluation& of) const;
  /// The time at which loads are to be taken for t.
  double load_time(double t) const;
  PointsState points_state(std::size_t body, const Evaluation& at, std::span<const double> y) const;
  double smallest_start_exponent(double t, const Evaluation& at) const;
  std::string describe_overflow(const Evaluation& at, std::span<const double> rate) const;

  EquilibriumSolver& solver_;
  Stopwatch& watch_;
  StateLayout layout_;
  ErrorScale scale_;
  std::vector<MaterialPoints> points_;    // one per body
  std::optional<TangentSystem> tangent_;  // made when it is first asked for
  std::vector<PointPreconditioner> preconditioners_;
  /// Bodies with internal variables: what is point-wise in their Newton systems, at local_gamma_.
  std::vector<std::unique_ptr<MaterialTangent>> local_;
  double local_gamma_ = 0;  // 0: to be prepared
  bool may_start_singular_ = false;
  double segment_begin_ = -std::numeric_limits<double>::infinity();
  double segment_end_ = std::numeric_limits<double>::infinity();
  History history_;
  Evaluation step_, output_;  // keyed by their (time, y)
  std::vector<mechanics::CreepStrainView> views_;
  std::vector<std::vector<double>> stress_change_;
  std::int64_t rate_evaluations_ = 0, jacobian_products_ = 0;
};

}  // namespace creepcontact::creep
