#include "creepcontact/material/material.hpp"

namespace creepcontact::material {

Moduli lame(double young_modulus, double poisson_ratio) {
  const double mu = young_modulus / (2.0 * (1.0 + poisson_ratio));
  return {2.0 * mu * poisson_ratio / (1.0 - 2.0 * poisson_ratio), mu};
}

int Material::n_state() const {
  if (!creeps()) return 0;
  int n = 6;
  for (const auto& law : creep) n += law->n_internal();
  return n;
}

}  // namespace creepcontact::material
