#pragma once
/// Ageing theory: the creep strain itself is a function of the current stress and time,
/// 3/2 (A q^n t^m)/q s. Where the stress falls, strain comes back; for stresses that change little.
/// Source: C. R. Soderberg, Trans. ASME 58 (1936); Y. N. Rabotnov, Creep Problems in Structural Members (1969).

#include "flow_law.hpp"
#include "law_table.hpp"
#include "power_law.hpp"

namespace creepcontact::material {

class Ageing final : public FlowLaw {
 public:
  /// @param values  by power_law::Constant
  explicit Ageing(const ParameterValues& values) : FlowLaw(first(values, power_law::n_constants)) {}
  std::string name() const override { return "ageing"; }
  bool is_isochronous() const override { return true; }
  /// @returns the equivalent creep strain, no rate
  EquivalentRate equivalent_rate(double q, const PointState& at) const override;
};

LawInfo ageing_info();

}  // namespace creepcontact::material
