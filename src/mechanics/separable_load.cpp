#include "separable_load.hpp"

#include <cmath>

namespace creepcontact::mechanics {

SeparableLoad::SeparableLoad(std::unique_ptr<SpatialIntegral> integral, Function f, Function factor, int power)
    : integral_(std::move(integral)), f_(std::move(f)), factor_(std::move(factor)), power_(power) {
  if (!f_.depends_on_position())
    steady_ = integrate(1.0, 0);
  else if (!f_.depends_on_time())
    steady_ = integrate(f_, 0);
}

std::vector<double> SeparableLoad::integrate(const Function& f, double t) const {
  std::vector<double> values(3 * integral_->nodes().size());
  integral_->add(f, t, values);
  return values;
}

void SeparableLoad::add(double t, std::span<double> forces) const {
  double scale = std::pow(factor_({.t = t}), power_);
  if (!f_.depends_on_position()) scale *= f_({.t = t});
  if (scale == 0) return;
  const std::vector<double> now = steady_.empty() ? integrate(f_, t) : std::vector<double>();
  const std::vector<double>& values = steady_.empty() ? now : steady_;
  const std::vector<std::int64_t>& nodes = integral_->nodes();
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) forces[3 * nodes[i] + k] += scale * values[3 * i + k];
}

}  // namespace creepcontact::mechanics
