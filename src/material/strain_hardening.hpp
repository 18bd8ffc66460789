#pragma once
/// Strain hardening: f = m A^(1/m) q^(n/m) eps^(1 - 1/m), the rate of the creep strain A q^n t^m of constant stress
/// written in the strain instead of the time. eps is the equivalent creep strain that this mechanism has accumulated;
/// a virgin point (eps = 0) under stress creeps infinitely fast if m < 1.
/// Source: A. Nadai, J. Appl. Phys. 8 (1937); Y. N. Rabotnov, Creep Problems in Structural Members (1969).

#include "hardening_law.hpp"
#include "law_table.hpp"
#include "power_law.hpp"

namespace creepcontact::material {

class StrainHardening final : public HardeningLaw {
 public:
  /// @param values  by power_law::Constant; m in (0, 1], the same at all temperatures
  /// @throws ParameterError if m is not
  StrainHardening(std::string name, const ParameterValues& values);
  std::string name() const override { return name_; }
  double equivalent_rate(double q, double eps, const PointState& at) const override;
  HardeningRate linearized_rate(double q, double eps, const PointState& at) const override;
  double accumulated(double q, double eps, const PointState& at, double duration) const override;
  /// m: wherever a load begins or jumps, some point may be virgin.
  double start_exponent(const PointState& at) const override { return at.parameters[power_law::m]; }

 private:
  std::string name_;
};

LawInfo strain_hardening_info();

}  // namespace creepcontact::material
