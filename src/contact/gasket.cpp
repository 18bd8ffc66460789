#include "creepcontact/contact/gasket.hpp"

#include <algorithm>
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

void GasketHistory::advance(double t, const Eigen::VectorXd& closures) {
  if (largest.size() == 0) return;
  for (Index i = 0; i < largest.size(); ++i) {
    double most = std::max(closures[i], closure.size() > 0 ? closure[i] : closures[i]);
    if (before.size() > 0 && t > time && time > time_before) {
      // Newton's form of the parabola: its summit lies between the three where the slope changes its sign.
      const double slope = (closure[i] - before[i]) / (time - time_before),
                   next = (closures[i] - closure[i]) / (t - time);
      const double curvature = (next - slope) / (t - time_before);
      const double at_begin = slope - curvature * (time - time_before);
      const double at_end = next + curvature * (t - time);
      if (curvature < 0 && at_begin > 0 && at_end < 0)
        most = std::max(most, before[i] - at_begin * at_begin / (4 * curvature));
    }
    largest[i] = std::max(largest[i], most);
  }
  const bool same_time = closure.size() > 0 && t == time;
  if (!same_time) {
    before = closure;
    time_before = time;
  }
  closure = closures;
  time = t;
}

}  // namespace creepcontact::contact
