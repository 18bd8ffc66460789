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
  virtual EquivalentRate equivalent_rate(double q, const Point& at) const = 0;

  void rate(const Point& at, double* strain_rate, double* internal_rate) const final;
  void derivative(const Point& at, const double* d_stress, const double* d_state, const double* d_internal,
                  double* d_strain_rate, double* d_internal_rate) const final;
  StressTangent stress_tangent(const Point& at) const final;
};

}  // namespace creepcontact::material
