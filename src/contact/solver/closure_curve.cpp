#include "creepcontact/contact/solver/closure_curve.hpp"

#include <algorithm>

namespace creepcontact::contact {

/// Number of the piece's first point.
Index ClosureCurve::piece(double closure) const {
  const auto end =
      std::ranges::lower_bound(points_, closure, {}, [](const Eigen::Vector2d& point) { return point.x(); });
  return std::clamp<Index>(end - points_.begin() - 1, 0, std::ssize(points_) - 2);
}

ClosureCurve::Line ClosureCurve::line(double closure) const {
  return line_of(piece(closure));
}

double ClosureCurve::closure(double pressure) const {
  const auto end =
      std::ranges::lower_bound(points_, pressure, {}, [](const Eigen::Vector2d& point) { return point.y(); });
  return line_of(std::clamp<Index>(end - points_.begin() - 1, 0, std::ssize(points_) - 2)).closure(pressure);
}

ClosureCurve::Line ClosureCurve::line_of(Index i) const {
  const Eigen::Vector2d &from = points_[static_cast<std::size_t>(i)], &to = points_[static_cast<std::size_t>(i) + 1];
  const double slope = (to.y() - from.y()) / (to.x() - from.x());
  return {from.x() - from.y() / slope, slope, pulls_};
}

double ClosureCurve::pressure(double closure) const {
  return line(closure).pressure(closure);
}

}  // namespace creepcontact::contact
