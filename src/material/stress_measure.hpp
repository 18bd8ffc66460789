#pragma once
/// The stress that damages: S = alpha max(X, 0) + (1 - alpha) q, between the von Mises stress (alpha = 0) and, with
/// X = sigma_1, the largest principal stress in tension (alpha = 1). X may also be the trace of the stress.
/// Source: D. R. Hayhurst, J. Mech. Phys. Solids 20 (1972).

#include "creepcontact/base/tensor.hpp"

namespace creepcontact::material {

/// X.
enum class DamagingTension { principal, trace };

/// S and the change of S with a change of the stress; the derivative exists where sigma_1 > 0 is a single eigenvalue
/// (of several equal ones any serves) and q > 0.
struct StressMeasure {
  double value = 0;
  Tensor6 gradient = Tensor6::Zero();

  /// Cost: an eigenvalue problem unless alpha = 0 or X is the trace.
  StressMeasure(const Tensor6& stress, double alpha, DamagingTension X = DamagingTension::principal);
};

}  // namespace creepcontact::material
