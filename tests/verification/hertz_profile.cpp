#include "verification/hertz_profile.hpp"

#include <algorithm>
#include <cmath>

namespace creepcontact::test {

std::string hertz_name(bool sphere, double upper_modulus, const std::string& slave) {
  const char* upper = upper_modulus > 1 ? "_upper_stiff" : upper_modulus < 1 ? "_upper_soft" : "_alike";
  return (sphere ? "sphere" : "cylinder") + (upper + ("_slave_" + slave));
}

HertzErrors hertz_errors(const std::vector<ContactPoint>& points, const reference::Hertz& exact, double area_radius,
                         const std::function<double(const Vector3&)>& r_of) {
  double peak = 0, overhang = 0, sum = 0, area = 0;
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const ContactPoint& point : points) {
    const double r = r_of(point.position), x = r * r / (exact.radius * exact.radius);
    const double p = point.pressure / exact.pressure, error = p - exact(r) / exact.pressure;
    peak = std::max(peak, p);
    if (x > 1) {
      overhang = std::max(overhang, p);
      continue;
    }
    sum += point.area * error * error;
    area += point.area;
    if (x < 0.25 || x > 0.9) continue;  // the slope near the edge, without the elements that the edge cuts
    n += 1, sx += x, sy += p * p, sxx += x * x, sxy += x * p * p;
  }
  const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx), at_centre = (sy - slope * sx) / n;
  return {std::sqrt(-at_centre / slope) - 1, area_radius / exact.radius - 1, peak - 1, std::sqrt(sum / area), overhang};
}

void expect_hertz(const HertzErrors& errors, double rms, const std::string& what) {
  EXPECT_LT(std::abs(errors.radius), 0.012) << what;
  EXPECT_LT(std::abs(errors.area), 0.02) << what;
  EXPECT_LT(std::abs(errors.peak), 0.006) << what;
  EXPECT_LT(errors.rms, rms) << what;
  EXPECT_LT(errors.overhang, 0.16) << what;
}

}  // namespace creepcontact::test
