#pragma once
/// Thick cylinder under internal pressure, plane strain: Lame's elastic stresses, and the steady state of Norton creep
/// (NAFEMS R0027, test 7; Odqvist & Hult 1962).

#include <cmath>

namespace creepcontact::reference {

struct ThickCylinder {
  double inner, outer, pressure;

  double elastic_sigma_r(double r) const { return lame() * (1 - square(outer / r)); }
  double elastic_sigma_theta(double r) const { return lame() * (1 + square(outer / r)); }
  double elastic_sigma_z(double poisson_ratio) const { return 2 * poisson_ratio * lame(); }
  double elastic_displacement(double r, double young_modulus, double poisson_ratio) const {
    return (1 + poisson_ratio) / young_modulus * lame() * ((1 - 2 * poisson_ratio) * r + outer * outer / r);
  }

  double steady_sigma_r(double r, double n) const { return -steady(n) * (shape(r, n) - 1); }
  double steady_sigma_theta(double r, double n) const { return steady(n) * (1 - (1 - 2 / n) * shape(r, n)); }
  double steady_sigma_z(double r, double n) const { return steady(n) * (1 - (1 - 1 / n) * shape(r, n)); }
  double steady_von_mises(double r, double n) const { return std::sqrt(3.0) / n * steady(n) * shape(r, n); }
  /// d(u)/dt = sqrt(3)/2 A q^n r
  double steady_displacement_rate(double r, double A, double n) const {
    return 0.5 * std::sqrt(3.0) * A * std::pow(steady_von_mises(r, n), n) * r;
  }

 private:
  static double square(double x) { return x * x; }
  double lame() const { return pressure / (square(outer / inner) - 1); }
  double shape(double r, double n) const { return std::pow(outer / r, 2 / n); }
  double steady(double n) const { return pressure / (shape(inner, n) - 1); }
};

}  // namespace creepcontact::reference
