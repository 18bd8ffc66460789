#pragma once
/// Life fraction L used up by creep: dL/dt = 1/t_r(S, T), with t_r the time to rupture at constant stress; L = 1 is
/// rupture. A mechanism without strain. S is the stress that causes damage, alpha max(sigma_1, 0) + (1 - alpha) q, with
/// the largest principal stress sigma_1 and the von Mises stress q.
/// Sources: E. L. Robinson, Trans. ASME 74 (1952); M. A. Miner (1945); S: D. R. Hayhurst, J. Mech. Phys. Solids 20
/// (1972).

#include "creepcontact/material/creep_law.hpp"

namespace creepcontact::material {

/// 1/t_r and its derivative with respect to S.
struct LifeRate {
  double value = 0, slope = 0;
};

/// Rupture data of a material. Immutable, thread-safe.
class RuptureData {
 public:
  virtual ~RuptureData() = default;
  /// @param stress  > 0
  virtual LifeRate rate(double stress, double temperature) const = 0;
};

/// @param rupture_time  t_r [time] as a function of q (the stress S) and T; where it is not positive, the rate is NaN
std::shared_ptr<const RuptureData> rupture_expression(Function rupture_time);

/// Larson-Miller data: P = (T - absolute_zero) (C + log10 t_r). P is linear in log10 S between the points, and
/// continued along the outermost two points beyond them. Source: F. R. Larson, J. Miller, Trans. ASME 74 (1952).
struct LarsonMiller {
  double constant = 20;            ///< C [-]
  std::vector<double> stress;      ///< S, increasing, > 0, at least two
  std::vector<double> parameter;   ///< P at these stresses, decreasing
  double absolute_zero = -273.15;  ///< in the user's unit of temperature
  double time_unit = 1;            ///< the user's in that of the data: 1/3600 if t is in seconds and t_r in hours
};
/// The rate is NaN at or below absolute zero.
/// @throws ParameterError if the data do not meet the conditions above
std::shared_ptr<const RuptureData> larson_miller(LarsonMiller data);

/// The mechanism with L as its only internal variable.
class LifeFraction final : public CreepLaw {
 public:
  /// @param data  not null @param alpha  weight of the largest principal stress in S, in [0, 1]
  LifeFraction(std::shared_ptr<const RuptureData> data, double alpha)
      : CreepLaw({}), data_(std::move(data)), alpha_(alpha) {}
  std::string name() const override { return "life_fraction"; }
  int n_internal() const override { return 1; }
  InternalKind internal_kind(int) const override { return InternalKind::life; }
  bool uses_mean_stress() const override { return alpha_ > 0; }
  bool strains() const override { return false; }

  void rate(const PointState& at, PointRate into) const override;
  void derivative(const PointState& at, const PointChange& change, PointRate into) const override;
  StressTangent stress_tangent(const PointState& /*at*/) const override { return {}; }
  bool evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const override;

 private:
  std::shared_ptr<const RuptureData> data_;
  double alpha_;
};

}  // namespace creepcontact::material
