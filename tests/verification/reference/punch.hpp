#pragma once
/// A rigid flat punch with a sharp edge on a half space, frictionless.
/// Source: K. L. Johnson, Contact Mechanics (1985), sections 2.8 (plane) and 3.4 (round).

#include <cmath>
#include <numbers>

namespace creepcontact::reference {

/// @param force  per length. @param a  half width
inline double flat_punch(double force, double a, double x) {
  return force / (std::numbers::pi * std::sqrt(a * a - x * x));
}

/// @param a  radius
inline double round_punch(double force, double a, double r) {
  return force / (2 * std::numbers::pi * a * std::sqrt(a * a - r * r));
}

}  // namespace creepcontact::reference
