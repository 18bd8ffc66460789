#pragma once
/// Derivatives by linear responses: what a value and the derivative of the state change in the equations of the run's
/// equilibrium is found at its own displacements, and answered by its own factors with its own closed contacts. What
/// the value changes itself is a difference of models with more and less of it. For piecewise linear equilibria.

#include "derivatives.hpp"
#include "nearby_model.hpp"

namespace creepcontact::run {

class LinearDerivatives final : public Derivatives {
 public:
  /// Whether this model has them; if not, they need models that run next to it.
  static bool suit(const creep::EquilibriumSolver& solver);

  /// @param values, system, solver, watch  must outlive the object
  LinearDerivatives(const std::vector<ChangedValue>& values, creep::CreepSystem& system,
                    creep::EquilibriumSolver& solver, std::vector<std::unique_ptr<NearbyModel>> models,
                    Stopwatch& watch);

  void rate(double t, std::span<const double> whole, std::span<double> rate) override;
  void start_increment(double t, std::span<const double> whole, double stress_time, double duration,
                       std::span<double> change) override;
  /// With the blocks of the diagonal: the derivatives follow the state an iteration later.
  void jacobian_times(double t, std::span<const double> whole, std::span<const double> v,
                      std::span<double> product) override;
  void accept(double t, std::span<const double> whole) override { base().accept(t, block(whole, 0)); }
  bool rate_has_jumped() const override { return base().rate_has_jumped(); }
  void forget_evaluations() override { base().forget_evaluations(); }
  void pass_breakpoint(double t, std::span<const double> whole) override;
  void follow_loads(double /*t*/) override {}
  std::vector<OfProbes> of_probes(double t, std::span<const double> whole) override;
  bool are_differences() const override { return false; }
  void save(creep::Memory& memory) const override;
  void restore(const creep::Memory& memory) override;
  void resume(double /*t*/, std::span<const double> /*whole*/) override {}

 private:
  NearbyModel& more(std::size_t k) const { return *models_[2 * k]; }
  NearbyModel& less(std::size_t k) const { return *models_[2 * k + 1]; }
  /// Whether what changes with value k in the equations depends on the displacements. @param at  its time and
  /// conditions
  bool follows_displacements(std::size_t k, const creep::Equilibrium& at) const;
  /// What changes with value k in the equations of the equilibrium, at the displacements of the run.
  /// @param at  of which time and conditions are known @param solved  all of it, if the value follows_displacements()
  /// @param change  of an earlier call, or new
  void equations(std::size_t k, const creep::Equilibrium& at, const creep::Evaluation* solved,
                 std::span<const double> state_change, creep::EquationChange& change);
  /// Memory for value k.
  creep::ChangeTask task(std::size_t k) { return {&equations_[k], &changes_[k]}; }
  /// The changes of the equilibrium with all values, up to the next call.
  const std::vector<creep::EquilibriumChange>& respond(const creep::Evaluation& at, std::span<const double> whole);
  void respond(std::span<const std::size_t> to, const creep::Evaluation& at, std::span<const double> whole);
  /// The evaluation of the run for steps, and with it the changes of its equilibrium with all values: those that do
  /// not follow_displacements() make the passes of the equilibrium.
  const creep::Evaluation& evaluate_with_changes(double t, std::span<const double> whole);
  /// Whether the laws of a body may have other rates in the same state.
  bool laws_differ(std::size_t k, std::size_t body, const creep::Evaluation& at) const;
  bool opens_or_closes(const creep::Equilibrium& at, const creep::EquilibriumChange& change) const;
  Eigen::VectorXd gap_of(const contact::Pair& pair) const;

  creep::EquilibriumSolver& solver_;
  Stopwatch& watch_;
  std::vector<std::unique_ptr<NearbyModel>> models_;  // two for each value: with more and with less of it
  /// Derivatives of the interference that preloads have given, by value and pair.
  std::vector<std::vector<double>> interference_;
  double preloaded_until_ = -1;
  // Memory of respond(): fresh pages for each step would cost as much as the laws.
  std::vector<creep::EquationChange> equations_;
  std::vector<creep::EquilibriumChange> changes_;
  std::vector<double> opposite_;
};

}  // namespace creepcontact::run
