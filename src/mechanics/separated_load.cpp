#include "separated_load.hpp"

#include <algorithm>
#include <cmath>

namespace creepcontact::mechanics {

SeparatedLoad::SeparatedLoad(std::unique_ptr<SpatialIntegral> integral, Function f, Function factor, int power)
    : integral_(std::move(integral)), f_(std::move(f)), factor_(std::move(factor)), power_(power) {
  forces_.nodes = integral_->nodes();
  forces_.values.resize(3 * forces_.nodes.size());
  integrate(f_.depends_on_place() ? f_ : Function(1.0), 0.0);
}

void SeparatedLoad::integrate(const Function& f, double t) {
  std::fill(forces_.values.begin(), forces_.values.end(), 0.0);
  integral_->add(f, t, forces_.values);
  integrated_at_ = t;
}

void SeparatedLoad::add(double t, std::span<double> forces) {
  double scale = std::pow(factor_({.t = t}), power_);
  if (!f_.depends_on_place()) {
    scale *= f_({.t = t});
  } else if (f_.depends_on_time() && t != integrated_at_) {
    integrate(f_, t);
  }
  if (scale == 0) return;
  for (std::size_t i = 0; i < forces_.nodes.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      forces[3 * static_cast<std::size_t>(forces_.nodes[i]) + k] += scale * forces_.values[3 * i + k];
}

}  // namespace creepcontact::mechanics
