#include "creepcontact/contact/geometry/polygon.hpp"

namespace creepcontact::contact {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

double area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return 0.5 * twice;
}

void clip(const Polygon& subject, const Polygon& window, Polygon& result, Polygon& work) {
  result = subject;
  for (std::size_t e = 0; e < window.size() && !result.empty(); ++e) {
    const Eigen::Vector2d& start = window[e];
    const Eigen::Vector2d edge = window[(e + 1) % window.size()] - start;
    work.swap(result);
    result.clear();
    for (std::size_t i = 0; i < work.size(); ++i) {
      const Eigen::Vector2d& a = work[i];
      const Eigen::Vector2d& b = work[(i + 1) % work.size()];
      const double inside_a = cross(edge, a - start);
      const double inside_b = cross(edge, b - start);
      if (inside_a >= 0) result.push_back(a);
      if ((inside_a > 0 && inside_b < 0) || (inside_a < 0 && inside_b > 0))
        result.push_back(a + (b - a) * (inside_a / (inside_a - inside_b)));
    }
  }
  if (result.size() < 3) result.clear();
}

}  // namespace creepcontact::contact
