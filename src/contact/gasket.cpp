#include "creepcontact/contact/gasket.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace creepcontact::contact {

Gasket::Gasket(std::shared_ptr<const GasketKind> kind, const std::optional<mechanics::TemperatureField>& temperature,
               const std::vector<Vector3>& positions)
    : kind_(std::move(kind)),
      n_nodes_(positions.size()),
      temperature_(temperature ? temperature->at(positions) : nullptr) {}

std::vector<double> Gasket::temperatures(double t) const {
  std::vector<double> result(n_nodes_, kind_->reference_temperature);
  mechanics::TemperatureMemo memo;
  if (temperature_) temperature_->evaluate(t, result, memo);
  return result;
}

std::vector<double> Gasket::growth(double t) const {
  if (kind_->expansion.is_zero()) return std::vector<double>(n_nodes_, 0.0);
  std::vector<double> result = temperatures(t);
  for (double& value : result)
    value = kind_->expansion({.T = value}) * kind_->law.thickness() * (value - kind_->reference_temperature);
  return result;
}

namespace {

/// The largest value of the parabola through three points within them; that of the points where it has no summit there,
/// or where the points are too uneven to tell.
double summit(const std::array<double, 3>& t, const std::array<double, 3>& c) {
  constexpr double most_uneven = 50;  // of the two intervals
  const double points = std::max({c[0], c[1], c[2]}), first = t[1] - t[0], second = t[2] - t[1];
  // Where it has fallen all the time, a summit would be one of the extrapolation.
  if (!(first > 0 && second > 0) || std::max(first / second, second / first) > most_uneven || c[0] == points)
    return points;
  const double slope = (c[1] - c[0]) / first, next = (c[2] - c[1]) / second;
  const double curvature = (next - slope) / (t[2] - t[0]);
  const double at_begin = slope - curvature * first, at_end = next + curvature * second;
  if (!(curvature < 0 && at_begin > 0 && at_end < 0)) return points;
  const double least = std::min({c[0], c[1], c[2]});
  return std::clamp(c[0] - at_begin * at_begin / (4 * curvature), points, points + (points - least));
}

}  // namespace

void GasketHistory::advance(double t, const Eigen::VectorXd& closures) {
  if (largest.size() == 0) return;
  for (Index i = 0; i < largest.size(); ++i) {
    double most = std::max(closures[i], closure.size() > 0 ? closure[i] : closures[i]);
    if (before.size() > 0) most = summit({time_before, time, t}, {before[i], closure[i], closures[i]});
    largest[i] = std::max(largest[i], most);
  }
  if (closure.size() == 0 || t != time) {
    before = closure;
    time_before = time;
  }
  closure = closures;
  time = t;
}

}  // namespace creepcontact::contact
