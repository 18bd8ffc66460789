#pragma once
/// Laws whose creep strain rate is coaxial with the stress deviator: rate = 3/2 (f/q) s, f = f(q, ...) the equivalent
/// rate.

#include "creepcontact/material/creep_law.hpp"

namespace creepcontact::material {

/// Equivalent creep rate and its derivative with respect to the equivalent stress.
struct EquivalentRate {
  double value = 0;  ///< f [1/time]
  double slope = 0;  ///< df/dq
};

/// Base of laws without internal variables. A law with hardening or damage derives from CreepLaw itself.
class FlowLaw : public CreepLaw {
 public:
  using CreepLaw::CreepLaw;
  /// @param q  von Mises equivalent stress, > 0
  virtual EquivalentRate equivalent_rate(double q, const PointState& at) const = 0;

  void rate(const PointState& at, PointRate into) const final;
  void derivative(const PointState& at, const PointChange& change, PointRate into) const final;
  StressTangent stress_tangent(const PointState& at) const final;
  StressTangent rate_and_tangent(const PointState& at, PointRate into) const final;
};

}  // namespace creepcontact::material
