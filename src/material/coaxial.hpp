#pragma once
/// Strain rates along the stress deviator: 3/2 (f/q) s, f the equivalent rate.

#include "creepcontact/base/instruction_sets.hpp"
#include "creepcontact/material/creep_law.hpp"

namespace creepcontact::material {

/// The q used for q -> 0 where only the limit of df/dq is wanted; far below any stress, far above underflow.
inline constexpr double vanishing_stress = 1e-150;

struct Deviator {
  Tensor6 s;
  double q;  ///< von Mises equivalent stress
};

CREEPCONTACT_INLINE Deviator deviator(const tensor::ConstMap& stress) {
  Deviator d{tensor::deviator(stress), 0.0};
  d.q = std::sqrt(1.5) * d.s.norm();
  return d;
}

/// Adds 3/2 (f/q) s; q > 0.
inline void add_flow(const Deviator& at, double f, tensor::Map strain) {
  strain.noalias() += 1.5 * f / at.q * at.s;
}

/// @param slope  df/dq; at q = 0 its limit, and f is not used
inline StressTangent coaxial_tangent(double q, double f, double slope) {
  if (q == 0.0) return {1.5 * slope, 0.0, 0.0};  // f/q -> df/dq
  const double secant = f / q;
  return {1.5 * secant, 1.5 * (slope - secant), 0.0};
}

/// Adds the change of the strain rate with a change of the stress, its deviator being ds.
inline void add_tangent(const Deviator& at, const StressTangent& c, const Tensor6& ds, tensor::Map strain_rate) {
  strain_rate.noalias() += c.deviatoric * ds;
  if (at.q > 0.0) strain_rate.noalias() += c.radial * 1.5 * (at.s.dot(ds) / at.q / at.q) * at.s;  // |s|^2 = 2/3 q^2
}

}  // namespace creepcontact::material
