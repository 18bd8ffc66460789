#pragma once
/// Norton's law of secondary creep: f = A q^n. Source: F. H. Norton, The Creep of Steel at High Temperatures (1929).

#include "flow_law.hpp"
#include "law_table.hpp"

namespace creepcontact::material {

class Norton final : public FlowLaw {
 public:
  enum Constant {
    A,  ///< [1/(time stress^n)]
    n,  ///< [-], >= 1
    n_constants
  };
  explicit Norton(const ParameterValues& values) : FlowLaw(first(values, n_constants)) {}
  std::string name() const override { return "norton"; }
  EquivalentRate equivalent_rate(double q, const PointState& at) const override;
};

LawInfo norton_info();

}  // namespace creepcontact::material
