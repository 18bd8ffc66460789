#pragma once
/// Garofalo's law: f = A sinh(alpha q)^n, Norton's law at low and exponential creep at high stress.
/// Source: F. Garofalo, Fundamentals of Creep and Creep-Rupture in Metals (1965).

#include "creepcontact/material/registry.hpp"
#include "flow_law.hpp"

namespace creepcontact::material {

class Garofalo final : public FlowLaw {
 public:
  /// @param A  [1/time]
  /// @param alpha  [1/stress]
  /// @param n  [-], >= 1
  Garofalo(Function A, Function alpha, Function n) : FlowLaw({std::move(A), std::move(alpha), std::move(n)}) {}
  std::string name() const override { return "garofalo"; }
  EquivalentRate equivalent_rate(double q, const PointState& at) const override;
};

LawInfo garofalo_info();

}  // namespace creepcontact::material
