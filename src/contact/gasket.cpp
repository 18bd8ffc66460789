#include "creepcontact/contact/gasket.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace creepcontact::contact {

Gasket::Gasket(std::shared_ptr<const GasketKind> kind, const std::optional<mechanics::TemperatureField>& temperature,
               std::vector<Vector3> positions)
    : kind_(std::move(kind)),
      positions_(std::move(positions)),
      temperature_(temperature ? temperature->at(positions_) : nullptr) {}

std::vector<double> Gasket::temperatures(double t) const {
  std::vector<double> result(positions_.size(), kind_->reference_temperature);
  mechanics::TemperatureMemo memo;
  if (temperature_) temperature_->evaluate(t, result, memo);
  return result;
}

std::vector<double> Gasket::growth(double t) const {
  if (kind_->expansion.is_zero()) return std::vector<double>(positions_.size(), 0.0);
  std::vector<double> result = temperatures(t);
  for (double& value : result)
    value = kind_->expansion({.T = value}) * kind_->law.thickness() * (value - kind_->reference_temperature);
  return result;
}

namespace {

/// The summit of the parabola through three points.
struct Summit {
  double value = 0;
  bool is_late = false;  ///< after the second point
};

/// nullopt where there is none between the points, or where these are too uneven to tell.
std::optional<Summit> summit_of(const std::array<double, 3>& t, const std::array<double, 3>& c) {
  constexpr double most_uneven = 50;  // of the two intervals
  const double points = std::max({c[0], c[1], c[2]}), first = t[1] - t[0], second = t[2] - t[1];
  // Where it has fallen all the time, a summit would be one of the extrapolation.
  if (!(first > 0 && second > 0) || std::max(first / second, second / first) > most_uneven || c[0] == points)
    return std::nullopt;
  const double slope = (c[1] - c[0]) / first, next = (c[2] - c[1]) / second;
  const double curvature = (next - slope) / (t[2] - t[0]);
  const double at_begin = slope - curvature * first, at_end = next + curvature * second;
  if (!(curvature < 0 && at_begin > 0 && at_end < 0)) return std::nullopt;
  const double least = std::min({c[0], c[1], c[2]});
  return Summit{std::clamp(c[0] - at_begin * at_begin / (4 * curvature), points, points + (points - least)),
                slope - curvature * (t[0] - t[1]) > 0};
}

}  // namespace

void GasketHistory::advance(double t, const Eigen::VectorXd& closures) {
  if (largest.size() == 0) return;
  if (error.size() == 0) error.setZero(largest.size());
  const Eigen::VectorXd found_before = std::exchange(summit, Eigen::VectorXd::Zero(largest.size()));
  for (Index i = 0; i < largest.size(); ++i) {
    const double points = std::max(closures[i], closure.size() > 0 ? closure[i] : closures[i]);
    const auto turn =
        before.size() > 0 ? summit_of({time_before, time, t}, {before[i], closure[i], closures[i]}) : std::nullopt;
    const double most = turn ? turn->value : points;
    if (turn && turn->is_late) summit[i] = most;
    const double known = turn && !turn->is_late && found_before.size() > 0 ? found_before[i] : 0;
    if (most > largest[i] || (known > 0 && known == largest[i]))
      error[i] = !turn ? 0 : known > 0 ? std::abs(most - known) : most - points;
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
