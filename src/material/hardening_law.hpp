#pragma once
/// Laws with one accumulated strain: rate = 3/2 (f/q) s, d eps/dt = f(q, eps, t, T), where eps is the equivalent creep
/// strain that this mechanism has accumulated.

#include "creepcontact/material/creep_law.hpp"

namespace creepcontact::material {

/// Equivalent creep rate and its partial derivatives.
struct HardeningRate {
  double value = 0;      ///< f [1/time]
  double by_stress = 0;  ///< df/dq
  double by_strain = 0;  ///< df/d eps
};

inline constexpr StateVariable hardening_strain{
    .name = "hardening_strain",
    .description = "equivalent creep strain that strain hardening has accumulated; 0 where there is none",
    .label = "hardening strain",
    .of_several = StateVariable::OfSeveralLaws::sum};

/// Base of laws with at most that one internal variable.
class HardeningLaw : public CreepLaw {
 public:
  int n_internal() const final { return accumulates_ ? 1 : 0; }
  /// @param q  von Mises equivalent stress, > 0
  /// @param eps  accumulated strain, at least PointState::min_strain (virgin points, and stages of an integrator that
  /// fall below 0, count as that: by_strain is then not used)
  virtual double equivalent_rate(double q, double eps, const PointState& at) const = 0;
  virtual HardeningRate linearized_rate(double q, double eps, const PointState& at) const = 0;
  /// Strain that accumulates in `duration` at constant q.
  /// @param eps  strain accumulated so far, at least 0
  virtual double accumulated(double q, double eps, const PointState& at, double duration) const = 0;

  void rate(const PointState& at, PointRate into) const final;
  void derivative(const PointState& at, const PointChange& change, PointRate into) const final;
  StressTangent stress_tangent(const PointState& at) const final;
  void increment(const PointState& at, double duration, PointIncrement into) const final;
  bool evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const final;

  /// The accumulated strain that equivalent_rate() sees.
  double strain(const PointState& at) const;

 protected:
  /// @param accumulates  false: f does not depend on eps, and there is no internal variable
  HardeningLaw(const ParameterValues& constants, bool accumulates) : CreepLaw(constants), accumulates_(accumulates) {}

 private:
  bool accumulates_;
};

}  // namespace creepcontact::material
