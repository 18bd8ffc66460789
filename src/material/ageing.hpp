#pragma once
/// Ageing theory: the creep strain itself is a function of the stress and the time of the moment,
/// 3/2 (A q^n t^m)/q s. Where the stress falls, strain comes back; for stresses that change little.
/// Source: C. R. Soderberg, Trans. ASME 58 (1936); Y. N. Rabotnov, Creep Problems in Structural Members (1969).

#include "creepcontact/material/registry.hpp"
#include "flow_law.hpp"

namespace creepcontact::material {

class Ageing final : public FlowLaw {
 public:
  /// @param A  [1/(time^m stress^n)], >= 0
  /// @param n  [-], >= 1
  /// @param m  [-], > 0
  Ageing(Function A, Function n, Function m) : FlowLaw({std::move(A), std::move(n), std::move(m)}) {}
  std::string name() const override { return "ageing"; }
  bool is_isochronous() const override { return true; }
  /// @returns the equivalent creep strain, no rate
  EquivalentRate equivalent_rate(double q, const PointState& at) const override;
};

LawInfo ageing_info();

}  // namespace creepcontact::material
