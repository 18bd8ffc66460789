#pragma once
/// Hertz contact of a sphere or a cylinder with a half space. Source: K. L. Johnson, Contact Mechanics (1985), ch. 4.

#include <algorithm>
#include <cmath>
#include <numbers>

namespace creepcontact::reference {

struct Elastic {
  double young_modulus, poisson_ratio;
};

/// E* of two bodies: 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2.
inline double contact_modulus(const Elastic& a, const Elastic& b) {
  return 1 / ((1 - a.poisson_ratio * a.poisson_ratio) / a.young_modulus +
              (1 - b.poisson_ratio * b.poisson_ratio) / b.young_modulus);
}

struct Hertz {
  double radius;    ///< contact radius, or half width
  double pressure;  ///< largest pressure

  double operator()(double r) const { return pressure * std::sqrt(std::max(0.0, 1 - r * r / (radius * radius))); }
};

/// @param force  the whole one. @param curvature  radius of the sphere R; gap = r^2/(2 R)
inline Hertz hertz_sphere(double force, double curvature, double modulus) {
  const double a = std::cbrt(3 * force * curvature / (4 * modulus));
  return {a, 3 * force / (2 * std::numbers::pi * a * a)};
}

/// @param force  per length
inline Hertz hertz_cylinder(double force, double curvature, double modulus) {
  const double a = std::sqrt(4 * force * curvature / (std::numbers::pi * modulus));
  return {a, 2 * force / (std::numbers::pi * a)};
}

}  // namespace creepcontact::reference
