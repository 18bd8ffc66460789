#pragma once
/// Creep of all bodies as a differential equation: y = creep strains and internal variables of every integration point,
/// f(t, y) = the laws' rates at the stress of the elastic contact equilibrium.

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/ode/system.hpp"
#include "creepcontact/simulation/contact_elasticity.hpp"
#include "creepcontact/simulation/material_points.hpp"
#include "creepcontact/simulation/material_tangent.hpp"
#include "creepcontact/simulation/state_layout.hpp"
#include "creepcontact/simulation/tangent_system.hpp"

namespace creepcontact::simulation {

class StressScale;

class CreepRate final : public ode::System {
 public:
  /// Solves for the elastic stress at the times that matter, to set the error scale.
  /// @param output_times  ascending, the last is the end of the run. @param elasticity, watch must outlive the object
  /// @param tolerance  that the integrator will keep: hardening below it is not resolved
  /// @throws ModelError if nothing gives any stress at any of these times, or if a body relaxes in 1e-12 of the run,
  /// which
  ///         units that do not fit together make
  CreepRate(ContactElasticity& elasticity, Stopwatch& watch, const std::vector<double>& output_times, double tolerance);

  ~CreepRate() override;

  std::size_t size() const override { return layout_.size(); }
  void rate(double t, std::span<const double> y, std::span<double> rate) override;
  /// J v = C H (B du - v) + (internal couplings), K du = B^T H v with the contact set frozen.
  void jacobian_times(double t, std::span<const double> y, std::span<const double> v,
                      std::span<double> product) override;
  void prepare_preconditioner(double t, std::span<const double> y) override;
  void precondition(double gamma, std::span<const double> r, std::span<double> z) override;
  /// Contact must be condensed to dense matrices (CondensedInterface::is_dense).
  /// Only where contact is condensed densely.
  bool offers_tangent() const override { return elasticity_.interface().is_dense(); }
  void prepare_tangent(double t, std::span<const double> y, double gamma) override;
  void solve_tangent(std::span<const double> r, std::span<double> z) override;
  double stable_step(double t, std::span<const double> y) override;
  bool may_start_singular() const override { return may_start_singular_; }
  double start_exponent(double t, std::span<const double> y) override;
  void start_increment(double t, std::span<const double> y, double stress_time, double duration,
                       std::span<double> change) override;
  /// Shortest of every body at the last evaluation: 1 / largest eigenvalue of C H; infinity where nothing creeps.
  std::vector<double> relaxation_times() const;
  /// Follows the stress of the accepted steps: typical stress / Young's modulus.
  std::span<const double> scale() const override;
  void accept(double t, std::span<const double> y) override;
  void forget_evaluations() override { evaluated_ = false; }
  Counters counters() const override;

  /// Loads, supports, gaps and temperatures may jump at both ends of the time from `begin` to `end`: from now on
  /// they are, at these times, their limits from within.
  void begin_segment(double begin, double end);

  /// All that evaluations to come depend on beside their arguments, for a checkpoint.
  void save(ContactElasticity::Memory& memory) const;
  /// @throws std::out_of_range if something is missing
  void restore(const ContactElasticity::Memory& memory);

  /// Equilibrium for a state, for output: fills elasticity().states().
  void equilibrium(double t, std::span<const double> y);

  bool knows(material::Measure measure) const;
  struct Extreme {
    double value = 0;
    std::size_t body = 0;
    Vector3 place = Vector3::Zero();
  };
  /// Largest value of a body, if one of its laws knows the measure; y is of the last evaluation or beside it.
  std::optional<Extreme> largest(material::Measure measure, std::size_t body, std::span<const double> y) const;
  /// Of every point of a body; empty if none of its laws knows the measure.
  std::vector<double> measure(material::Measure of, std::size_t body, std::span<const double> y) const;

  ContactElasticity& elasticity() { return elasticity_; }
  const ContactElasticity& elasticity() const { return elasticity_; }
  const StateLayout& layout() const { return layout_; }

 private:
  /// @throws ModelError if the elastic state of this time, which `state_` and the elasticity hold, relaxes in no time
  void require_relaxation_in_the_run(double t, double end);
  /// Stress at (t, y): solved, or kept from the last call if that was at the same point. @returns whether it was solved
  void require_finite_stress(double t) const;
  bool evaluate(double t, std::span<const double> y);
  /// The time at which loads are to be taken for t.
  double load_time(double t) const;
  std::string describe_overflow(std::span<const double> rate) const;
  double smallest_start_exponent(double t, std::span<const double> y) const;
  void set_scale(const std::vector<double>& output_times);
  /// Typical stress of every body without creep, the largest over these times.
  std::vector<double> elastic_stresses(const std::vector<double>& times, double end);

  ContactElasticity& elasticity_;
  Stopwatch& watch_;
  StateLayout layout_;
  std::vector<MaterialPoints> points_;    // one a body
  std::optional<TangentSystem> tangent_;  // made when it is first asked for
  /// Bodies with internal variables: what is point-wise in their Newton systems, at local_gamma_.
  std::vector<std::unique_ptr<MaterialTangent>> local_;
  double local_gamma_ = 0;  // 0: to be prepared
  bool may_start_singular_ = false;
  std::unique_ptr<StressScale> scale_;
  double segment_begin_ = -std::numeric_limits<double>::infinity();
  double segment_end_ = std::numeric_limits<double>::infinity();
  bool evaluated_ = false;
  double time_ = 0;            // of the loads
  std::vector<double> state_;  // of the last evaluation
  bool for_output_ = false;    // the last evaluation was no integrator's
  std::vector<mechanics::CreepStrainView> views_;
  std::vector<std::vector<double>> stress_change_;
  std::int64_t rate_evaluations_ = 0, jacobian_products_ = 0;
};

}  // namespace creepcontact::simulation
