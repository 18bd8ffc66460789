#pragma once
/// Pressure over closure of a gasket at one contact node, for one temperature and one history of loading.

#include <Eigen/Core>
#include <vector>

#include "creepcontact/base/index.hpp"

namespace creepcontact::contact {

/// A continuous function of straight pieces: zero up to its first point, increasing beyond it; beyond the last point
/// its last piece goes on. One that pulls, of a spring, has its first piece before the first point too. Closures and
/// pressures are in the units of the model.
class ClosureCurve {
 public:
  ClosureCurve() = default;
  /// @param points  (closure, pressure), at least two, both increasing strictly; the first pressure is 0 unless it
  /// pulls
  explicit ClosureCurve(std::vector<Eigen::Vector2d> points, bool pulls = false)
      : points_(std::move(points)), pulls_(pulls) {}

  /// True in nodes without a gasket.
  bool empty() const { return points_.empty(); }
  double pressure(double closure) const;
  /// The closure at a pressure above 0.
  double closure(double pressure) const;
  /// The closure where pressure begins.
  double begin() const { return points_.front().x(); }
  /// The closure of the last point.
  double end() const { return points_.back().x(); }
  /// Multiplies the pressures by a positive factor.
  void scale(double factor) {
    for (Eigen::Vector2d& point : points_) point.y() *= factor;
  }
  bool pulls() const { return pulls_; }
  /// A line max(0, slope (closure - zero)), or without the bound if it pulls.
  struct Line {
    double zero = 0;
    double slope = 0;  ///< [pressure/length], positive
    bool pulls = false;
    double pressure(double closure) const { return pulls || closure > zero ? slope * (closure - zero) : 0.0; }
    double closure(double pressure) const { return zero + pressure / slope; }
  };
  /// The line of the piece that ends at this closure or contains it; below the first point that of the first piece.
  Line line(double closure) const;

 private:
  Index piece(double closure) const;
  Line line_of(Index piece) const;

  std::vector<Eigen::Vector2d> points_;
  bool pulls_ = false;
};

}  // namespace creepcontact::contact
