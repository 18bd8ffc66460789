#pragma once
/// Figures of a pressure distribution beside those of Hertz.

#include <functional>
#include <string>
#include <vector>

#include "verification/contact_state.hpp"
#include "verification/reference/hertz.hpp"

namespace creepcontact::test {

/// All relative to the exact contact radius and the exact largest pressure.
struct HertzErrors {
  double radius;    ///< of the zero of the straight line through the squared pressure over r^2
  double area;      ///< of the radius that belongs to contact_area
  double peak;      ///< of the largest pressure
  double rms;       ///< of the pressure over the contact
  double overhang;  ///< largest pressure outside of the contact
};

/// Name of a parameterised test.
std::string hertz_name(bool sphere, double upper_modulus, const std::string& slave);

/// @param r_of  distance of a contact point from the centre. @param area_radius  what contact_area says
HertzErrors hertz_errors(const std::vector<ContactPoint>& points, const reference::Hertz& exact, double area_radius,
                         const std::function<double(const Vector3&)>& r_of);

/// Bounds on the errors of a mesh with eight or more elements over the contact radius.
void expect_hertz(const HertzErrors& errors, double rms, const std::string& what);

}  // namespace creepcontact::test
