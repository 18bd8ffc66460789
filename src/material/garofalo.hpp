#pragma once
/// Garofalo's law: f = A sinh(alpha q)^n, Norton's law at low and exponential creep at high stress.
/// Source: F. Garofalo, Fundamentals of Creep and Creep-Rupture in Metals (1965).

#include "flow_law.hpp"
#include "law_table.hpp"

namespace creepcontact::material {

class Garofalo final : public FlowLaw {
 public:
  enum Constant {
    A,      ///< [1/time]
    alpha,  ///< [1/stress]
    n,      ///< [-], >= 1
    n_constants
  };
  explicit Garofalo(const ParameterValues& values) : FlowLaw(first(values, n_constants)) {}
  std::string name() const override { return "garofalo"; }
  EquivalentRate equivalent_rate(double q, const PointState& at) const override;
};

LawInfo garofalo_info();

}  // namespace creepcontact::material
