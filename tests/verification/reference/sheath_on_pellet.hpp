#pragma once
/// Creeping sheath on an elastic pellet, plane strain: SSNA105 of the code_aster validation manual (V6.01.105).
/// Norton's law with n = 1 (rate = 3/2 K s) leaves Lame's stresses in the plane; only sigma_z relaxes to their mean.

#include <cmath>

namespace creepcontact::reference {

/// Elastic displacement of a tube in plane strain under pressure inside and outside (Lame).
struct ElasticCylinder {
  double inner, outer, young_modulus, poisson_ratio;

  double displacement(double pressure_inside, double pressure_outside, double r) const {
    const double a = inner * inner, b = outer * outer, nu = poisson_ratio;
    return (1 + nu) / (young_modulus * (b - a)) *
           ((1 - 2 * nu) * (pressure_inside * a - pressure_outside * b) * r +
            (pressure_inside - pressure_outside) * a * b / r);
  }
  /// Inside pressure that gives the outer surface this displacement.
  double pressure_inside(double outer_displacement, double pressure_outside) const {
    const double unit = displacement(1, 0, outer);
    return (outer_displacement - displacement(0, pressure_outside, outer)) / unit;
  }
};

/// Tube of linearly creeping material in plane strain, a pressure put on one of its surfaces at t = 0 and held.
struct CreepingCylinder {
  double pressed, free;  ///< radii: the surface under pressure, the other one
  double young_modulus, poisson_ratio, K;

  /// Half the in-plane trace of the stress, (sigma_r + sigma_theta) / 2
  double mean_stress(double pressure) const { return pressure * pressed * pressed / (free * free - pressed * pressed); }
  double displacement(double pressure, double r, double t) const {
    const double E = young_modulus, nu = poisson_ratio, ratio = free * free / (r * r);
    return mean_stress(pressure) * r *
           (((1 + nu) * ratio + 1.5 * (1 - 2 * nu)) / E - (1 - 2 * nu) * (1 - 2 * nu) * std::exp(-E * K * t) / (2 * E) +
            1.5 * K * ratio * t);
  }
  double sigma_r(double pressure, double r) const { return mean_stress(pressure) * (1 - free * free / (r * r)); }
  double sigma_theta(double pressure, double r) const { return mean_stress(pressure) * (1 + free * free / (r * r)); }
  double sigma_z(double pressure, double t) const {
    return mean_stress(pressure) * (1 - (1 - 2 * poisson_ratio) * std::exp(-young_modulus * K * t));
  }
};

struct SheathOnPellet {
  CreepingCylinder sheath{1.0, 2.0, 1.0, 0.3, 1.0};
  ElasticCylinder pellet{0.82, 0.98, 1.0, 0.3};
  double contact_pressure = 1e-3;  ///< on the sheath

  double gap() const { return sheath.pressed - pellet.outer; }
  /// The same radial force on the pellet's smaller surface.
  double pellet_outer_pressure() const { return contact_pressure * sheath.pressed / pellet.outer; }
  /// Pressure in the pellet's bore that keeps the contact pressure: its outer surface follows the sheath through the
  /// gap.
  double bore_pressure(double t) const {
    const double follow = gap() + sheath.displacement(contact_pressure, sheath.pressed, t);
    return pellet.pressure_inside(follow, pellet_outer_pressure());
  }
};

}  // namespace creepcontact::reference
