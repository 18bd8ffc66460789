#pragma once
/// Creep-fatigue life: the life fraction L of creep (Robinson), the cycle fraction F of fatigue (Miner), and what of an
/// interaction diagram they have used up. A mechanism without strain.
///   dL/dt = 1/t_r(S, T),   each cycle adds 1/N_f(strain range, T) to F.
/// The strain range is the largest over pairs of times of the cycle of sqrt(2/3 e:e). Here e is the deviator of the
/// difference of the total strains (elastic + inelastic; thermal strain has no deviator). T is the highest temperature
/// of the cycle.
/// Sources: E. L. Robinson, Trans. ASME 74 (1952); M. A. Miner, J. Appl. Mech. 12 (1945); strain range and diagram:
/// ASME BPVC III.5, Appendix HBB-T (nu* = 0.5).

#include <array>
#include <memory>
#include <vector>

#include "creepcontact/material/life_fraction.hpp"

namespace creepcontact::material {

/// Number of cycles to failure N_f. Immutable, thread-safe.
class FatigueCurve {
 public:
  virtual ~FatigueCurve() = default;
  /// @param strain_range  > 0 @returns infinity: no damage; a value <= 0 makes the damage NaN
  virtual double cycles(double strain_range, double temperature) const = 0;
};

/// @param cycles  N_f as a function of eps (the strain range) and T
std::shared_ptr<const FatigueCurve> fatigue_expression(Function cycles);
/// log N_f is linear in log(strain range) between the points, and continued along the outermost two points beyond them.
/// @param strain_range  increasing, > 0, at least two @param cycles  decreasing, > 0
/// @throws ParameterError if they are not
std::shared_ptr<const FatigueCurve> fatigue_table(std::vector<double> strain_range, std::vector<double> cycles);

/// The line in the plane of life fraction and cycle fraction up to which a design is allowed: straight from (0, 1)
/// through the given points to (1, 0). Without points, L + F = 1.
class InteractionDiagram {
 public:
  using Point = std::array<double, 2>;  ///< life fraction, cycle fraction
  InteractionDiagram() : InteractionDiagram(std::vector<Point>{}) {}
  /// @param points  in (0, 1), the first fraction increasing, the second one decreasing
  /// @throws ParameterError if they are not
  explicit InteractionDiagram(std::vector<Point> points);
  /// Length of the way to (life, cycles) from the origin relative to that to the line: 1 on the line.
  double usage(double life, double cycles) const;

 private:
  std::vector<Point> points_;  // the ends included
};

/// Internal variables: L, F.
class CreepFatigue final : public CreepLaw {
 public:
  /// @param curve  not null @param creep  null: without rupture data, L stays 0
  CreepFatigue(std::shared_ptr<const FatigueCurve> curve, InteractionDiagram diagram,
               std::shared_ptr<const LifeFraction> creep)
      : CreepLaw({}), curve_(std::move(curve)), diagram_(std::move(diagram)), creep_(std::move(creep)) {}
  std::string name() const override { return "creep_fatigue"; }
  int n_internal() const override { return 2; }
  InternalKind internal_kind(int) const override { return InternalKind::life; }
  bool uses_mean_stress() const override { return creep_ && creep_->uses_mean_stress(); }

  void rate(const PointState& at, PointRate into) const override;
  void derivative(const PointState& at, const PointChange& change, PointRate into) const override;
  StressTangent stress_tangent(const PointState& /*at*/) const override { return {}; }
  bool evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const override;
  bool counts_cycles() const override { return true; }
  /// @throws ModelError if the number of cycles to failure is not positive
  void add_cycle(const CycleRange& cycle, std::span<double> internal) const override;

 private:
  /// What the part of creep sees.
  static PointState of_creep(const PointState& at);

  std::shared_ptr<const FatigueCurve> curve_;
  InteractionDiagram diagram_;
  std::shared_ptr<const LifeFraction> creep_;
};

}  // namespace creepcontact::material
