#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/material/creep_fatigue.hpp"
#include "creepcontact/material/registry.hpp"
#include "ordered_values.hpp"

namespace creepcontact::material {
namespace {

class FatigueExpression final : public FatigueCurve {
 public:
  explicit FatigueExpression(Function cycles) : cycles_(std::move(cycles)) {}
  double cycles(double strain_range, double temperature) const override {
    return cycles_({.T = temperature, .eps = strain_range});
  }

 private:
  Function cycles_;
};

class FatigueTable final : public FatigueCurve {
 public:
  FatigueTable(const std::vector<double>& strain_range, const std::vector<double>& cycles) {
    for (std::size_t i = 0; i < strain_range.size(); ++i) {
      range_.push_back(std::log(strain_range[i]));
      cycles_.push_back(std::log(cycles[i]));
    }
  }
  double cycles(double strain_range, double /*temperature*/) const override {
    const double x = std::log(strain_range);
    // The piece that x is in; the first or last one beyond the ends.
    const auto next = std::upper_bound(range_.begin() + 1, range_.end() - 1, x);
    const std::size_t i = next - range_.begin();
    const double slope = (cycles_[i] - cycles_[i - 1]) / (range_[i] - range_[i - 1]);
    return std::exp(cycles_[i - 1] + slope * (x - range_[i - 1]));
  }

 private:
  std::vector<double> range_, cycles_;  // logarithms
};

double cross(const InteractionDiagram::Point& a, const InteractionDiagram::Point& b) {
  return a[0] * b[1] - a[1] * b[0];
}

}  // namespace

std::shared_ptr<const FatigueCurve> fatigue_expression(Function cycles) {
  return std::make_shared<FatigueExpression>(std::move(cycles));
}

std::shared_ptr<const FatigueCurve> fatigue_table(std::vector<double> strain_range, std::vector<double> cycles) {
  if (strain_range.size() < 2)
    throw ParameterError("strain_range", fmt::format("{} values", strain_range.size()), "at least two values");
  if (cycles.size() != strain_range.size())
    throw ParameterError("cycles", fmt::format("{} values", cycles.size()),
                         fmt::format("as many values as 'strain_range' has: {}", strain_range.size()));
  require_order("strain_range", strain_range, true);
  require_order("cycles", cycles, false, "values that decrease as the strain range increases");
  for (const auto& [key, least] : {std::pair("strain_range", strain_range.front()), std::pair("cycles", cycles.back())})
    if (!(least > 0)) throw ParameterError(key, fmt::format("the number {}", least), "numbers > 0");
  return std::make_shared<FatigueTable>(strain_range, cycles);
}

InteractionDiagram::InteractionDiagram(std::vector<Point> points) : points_(std::move(points)) {
  points_.insert(points_.begin(), {0, 1});
  points_.push_back({1, 0});
  for (std::size_t i = 1; i < points_.size(); ++i)
    if (!(points_[i][0] > points_[i - 1][0] && points_[i][1] < points_[i - 1][1]))
      throw ParameterError(
          "interaction",
          fmt::format("[{}, {}] after [{}, {}]", points_[i][0], points_[i][1], points_[i - 1][0], points_[i - 1][1]),
          "points [life fraction, cycle fraction] between [0, 1] and [1, 0], the first number "
          "increasing and the second one decreasing");
}

double InteractionDiagram::usage(double life, double cycles) const {
  const Point at{life, cycles};
  double result = 0;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    // at = a of one end + b of the other; on the line between them a + b = 1.
    const Point &from = points_[i - 1], &to = points_[i];
    const double area = cross(from, to), a = cross(at, to) / area, b = cross(from, at) / area;
    result = a + b;
    if (b >= 0 && a >= 0) break;
  }
  return result;
}

}  // namespace creepcontact::material
