#pragma once
/// A material: isotropic or orthotropic elasticity and thermal expansion, and its creep mechanisms.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/material/anisotropy.hpp"
#include "creepcontact/material/creep_law.hpp"
#include "creepcontact/material/plasticity.hpp"

namespace creepcontact::material {

/// Lame's constants, computed by lame() from Young's modulus and Poisson's ratio.
struct Moduli {
  double lambda = 0, mu = 0;
};
Moduli lame(double young_modulus, double poisson_ratio);

/// stress = lambda tr(e) I + 2 mu e, Mandel order
inline Tensor6 stress(const Moduli& h, const Tensor6& elastic_strain) {
  Tensor6 s = 2.0 * h.mu * elastic_strain;
  s.head<3>().array() += h.lambda * tensor::trace(elastic_strain);
  return s;
}

/// Elastic strain for a stress: the inverse of stress(), Mandel order.
inline Tensor6 elastic_strain(const Moduli& h, const Tensor6& stress) {
  Tensor6 e = stress / (2.0 * h.mu);
  e.head<3>().array() -= h.lambda / (2.0 * h.mu * (3.0 * h.lambda + 2.0 * h.mu)) * tensor::trace(stress);
  return e;
}

/// Functions of the temperature T; the creep laws are shared and immutable.
struct Material {
  std::string name;
  Function young_modulus;  ///< of T
  Function poisson_ratio;  ///< of T
  ThermalExpansion thermal_expansion;
  double reference_temperature = 0.0;
  /// If given, this is the elasticity, and young_modulus and poisson_ratio are isotropic averages for scales.
  std::optional<Orthotropy> orthotropy;
  std::optional<HillRatios> hill;  ///< of all creep laws; not of the life fraction
  std::vector<std::shared_ptr<const CreepLaw>> creep;
  std::shared_ptr<const Plasticity> plasticity;  ///< null: the material does not yield
  std::optional<Function> yield_strength;        ///< of T: what results compare the stress with

  bool has_axes() const { return orthotropy || hill || thermal_expansion.has_axes; }
  bool creeps() const { return !creep.empty(); }
  /// State variables per point: 6 (creep strain) + internal variables of all laws; 0 for an elastic material.
  int n_state() const;
};

}  // namespace creepcontact::material
