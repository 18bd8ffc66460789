#pragma once
/// The constants of the creep strain A q^n t^m at constant stress, which several laws have.

#include "creepcontact/material/registry.hpp"

namespace creepcontact::material::power_law {

enum Constant {
  A,  ///< [1/(time^m stress^n)], >= 0
  n,  ///< [-], >= 1
  m,  ///< [-], > 0
  n_constants
};

/// The row of A.
inline ParameterInfo factor() {
  return {.key = "A",
          .description = "creep strain at unit equivalent stress and time [1/(time^m stress^n)]",
          .dimension = unit::none / unit::pow(unit::time, m) / unit::pow(unit::stress, n),
          .strict = false,
          .activation = Activation::rate};
}

}  // namespace creepcontact::material::power_law
