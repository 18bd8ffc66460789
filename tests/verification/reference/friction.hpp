#pragma once
/// Closed forms of contact with Coulomb friction.

#include <cmath>
#include <numbers>

#include "verification/reference/hertz.hpp"

namespace creepcontact::reference {

/// A strip pressed on a stiff foundation and pulled at one end: it slips from that end inwards. Derived from the
/// balance of a bar with the shear mu p on one side; unloading by Masing's rule (1926). Creep: the stationary rate of
/// Norton's law in plane strain at the stress of that balance.
struct PulledStrip {
  double modulus;    ///< E, in plane strain E/(1 - nu^2)
  double thickness;  ///< h
  double friction, pressure;

  double slip_length(double force) const { return force / (friction * pressure); }
  /// Of the end, as the force (per width) grows from zero.
  double displacement(double force) const { return force * slip_length(force) / (2 * modulus * thickness); }
  /// As the force falls from `largest`, not below its opposite.
  double unloading(double force, double largest) const {
    return displacement(largest) - 2 * displacement((largest - force) / 2);
  }
  /// Energy lost in a cycle between force and -force; the first loading loses a quarter of it.
  double loop_energy(double force) const { return 4.0 / 3 * force * displacement(force); }
  /// Velocity of the end under a constant force, incompressible material with the creep rate A q^n.
  double creep_velocity(double force, double A, double n) const {
    const double axial = A * std::pow(std::sqrt(3.0) / 2, n + 1);
    return axial * thickness / ((n + 1) * friction * pressure) *
           (std::pow(force / thickness + pressure, n + 1) - std::pow(pressure, n + 1));
  }
};

/// Two alike cylinders or spheres pressed by P and then sheared by Q < mu P: shear traction mu (p(P) - p(P - Q/mu)).
/// Sources: C. Cattaneo (1938), R. D. Mindlin (1949); plane bodies of any shape: M. Ciavarella (1998), J. Jaeger
/// (1998).
struct CattaneoMindlin {
  double friction;
  Hertz full, reduced;  ///< under P and under P - Q/mu

  double shear(double r) const { return friction * (full(r) - reduced(r)); }
  double stick_radius() const { return reduced.radius; }
};

}  // namespace creepcontact::reference
