#pragma once
/// Norton's law of secondary creep: f = A q^n. Source: F. H. Norton, The Creep of Steel at High Temperatures (1929).

#include "creepcontact/material/registry.hpp"
#include "flow_law.hpp"

namespace creepcontact::material {

class Norton final : public FlowLaw {
 public:
  /// @param A  [1/(time stress^n)]
  /// @param n  [-], >= 1
  Norton(Function A, Function n) : FlowLaw({std::move(A), std::move(n)}) {}
  std::string name() const override { return "norton"; }
  EquivalentRate equivalent_rate(double q, const PointState& at) const override;
};

LawInfo norton_info();

}  // namespace creepcontact::material
