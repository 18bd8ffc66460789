#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/ode/system.hpp"
#include "creepcontact/simulation/creep_rate.hpp"

namespace creepcontact::simulation {

/// Laws take a stress that is no number for none, and a run would go on without creep.
void CreepRate::require_finite_stress(double t) const {
  for (std::size_t b = 0; b < points_.size(); ++b) {
    const std::vector<double>& stress = elasticity_.states()[b].stress;
    const double sum = Eigen::Map<const Eigen::VectorXd>(stress.data(), static_cast<Eigen::Index>(stress.size())).sum();
    if (!std::isfinite(sum))
      throw ode::RecoverableError(
          fmt::format("the stress of body '{}' has grown beyond all bounds at t = {:.6g}; take shorter steps, or an "
                      "integrator with error control",
                      elasticity_.model().bodies[b]->name(), t));
  }
}

std::string CreepRate::describe_overflow(std::span<const double> rate) const {
  for (std::size_t b = 0; b < points_.size(); ++b) {
    const std::size_t stride = layout_.stride(b);
    for (std::size_t p = 0; stride > 0 && p < points_[b].size(); ++p) {
      const auto own = rate.subspan(layout_.offset(b) + p * stride, stride);
      if (std::ranges::all_of(own, [](double value) { return std::isfinite(value); })) continue;
      const mechanics::Body& body = *elasticity_.model().bodies[b];
      const Vector3& x = body.discretization().point_coordinates()[p];
      const Eigen::Map<const Tensor6> stress(elasticity_.states()[b].stress.data() + 6 * p);
      return fmt::format(
          "the creep rate of material '{}' overflows, is negative or no number in body '{}' at ({:.6g}, {:.6g}, "
          "{:.6g}), where the equivalent stress is {:.6g} and t = {:.6g}; look at its creep constants and their units",
          body.material().name, body.name(), x.x(), x.y(), x.z(), tensor::von_mises(stress), time_);
    }
  }
  return "the creep rate overflows";
}

}  // namespace creepcontact::simulation
