#include "creepcontact/creep/relaxation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "creepcontact/numerics/point_sums.hpp"

namespace creepcontact::creep {
namespace {

constexpr double max_ratio = 1e12;  // times the time that the search starts from
constexpr double time_tolerance = 1e-6;

std::vector<double> grown_until(double end, const MaterialPoints& points, const PointsState& at) {
  std::vector<double> change(points.size() * points.stride(), 0.0);
  points.add_increment(0, end, at, change);
  return change;
}

/// Creep over elastic strain at each point; 0 where there is no stress.
std::vector<double> ratios(double end, const MaterialPoints& points, const PointsState& at) {
  const std::vector<double> change = grown_until(end, points, at);
  const mechanics::CreepStrainView grown{change, points.stride()};
  std::vector<double> values(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Tensor6 stress = tensor::view(at.stress, p);
    const double stored = stress.dot(at.elastic.elastic_strain(p, stress));
    values[p] = stored > 0 ? stress.dot(grown.at(p)) / stored : 0;
  }
  return values;
}

/// The time at which a ratio that grows from zero reaches one: false position in the logarithms, which is exact for
/// powers of time, within ends that always enclose it.
double time_of_one(const std::function<double(double)>& ratio, double near) {
  double low = near, high = near, at_low = ratio(near), at_high = at_low;
  if (std::isnan(at_low)) return at_low;
  while (at_low > 1 && low > near / max_ratio) low /= 10, at_low = ratio(low);
  while (at_high < 1 && high < near * max_ratio) high *= 10, at_high = ratio(high);
  if (!(at_high >= 1)) return std::numeric_limits<double>::infinity();
  if (!(at_low <= 1)) return 0;
  for (int halving = 0; halving < 60 && high > low * (1 + time_tolerance); ++halving) {
    const double slope = std::log(at_high / at_low) / std::log(high / low);
    double middle = low * std::pow(at_low, -1 / slope);
    // Every other guess halves the interval: one end may stay where it is.
    if (halving % 2 == 1 || !(middle > low && middle < high)) middle = std::sqrt(low * high);
    const double there = ratio(middle);
    if (std::abs(there - 1) <= time_tolerance) return middle;
    if (there < 1)
      low = middle, at_low = there;
    else
      high = middle, at_high = there;
  }
  return std::sqrt(low * high);
}

}  // namespace

double creep_over_elastic_strain(const Team& team, const MaterialPoints& points, const PointsState& at, double end) {
  const std::vector<double> change = grown_until(end, points, at);
  const std::span<const double> weights = points.body().discretization().weights();
  const mechanics::CreepStrainView grown{change, points.stride()};
  const double stored = numerics::sum_over_points(points.size(), [&](std::size_t p) {
    const Tensor6 stress = tensor::view(at.stress, p);
    return weights[p] * stress.dot(at.elastic.elastic_strain(p, stress));
  });
  const double spent = numerics::sum_over_points(
      points.size(), [&](std::size_t p) { return weights[p] * tensor::view(at.stress, p).dot(grown.at(p)); });
  return team.sum(spent) / team.sum(stored);
}

RelaxationTime relaxation_time(const Team& team, const MaterialPoints& points, const PointsState& at, double near) {
  const double whole = time_of_one([&](double t) { return creep_over_elastic_strain(team, points, at, t); }, near);
  if (std::isnan(whole)) return {whole, whole};
  const double from = std::isfinite(whole) && whole > 0 ? whole : near;
  std::array<double, 4> fastest{std::numeric_limits<double>::infinity()};
  const std::vector<double> then = ratios(from, points, at);
  if (const auto most = std::ranges::max_element(then); most != then.end()) {
    const std::size_t p = most - then.begin();
    const Vector3& x = points.body().discretization().point_coordinates()[p];
    fastest = {time_of_one([&](double t) { return ratios(t, points, at)[p]; }, from), x.x(), x.y(), x.z()};
  }
  team.broadcast(fastest, team.rank_of_max(-fastest[0]));
  return {whole, fastest[0], {fastest[1], fastest[2], fastest[3]}};
}

}  // namespace creepcontact::creep
