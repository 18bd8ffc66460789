#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/numerics/point_sums.hpp"
#include "creepcontact/ode/system.hpp"
#include "creepcontact/simulation/creep_rate.hpp"
#include "stress_scale.hpp"

namespace creepcontact::simulation {
namespace {

constexpr double most_creep = 1e12;  // of the elastic strain, over the run: no machine part lives through so much

/// sigma : C sigma
double elastic_work(const Tensor6& stress, const material::Moduli& moduli) {
  const double trace = tensor::trace(stress);
  return tensor::deviator(stress).squaredNorm() / (2 * moduli.mu) +
         trace * trace / (3 * (3 * moduli.lambda + 2 * moduli.mu));
}

}  // namespace

void CreepRate::require_relaxation_in_the_run(double t, double end) {
  std::string mistakes;
  std::vector<double> change(size(), 0.0);
  for (std::size_t b = 0; b < points_.size(); ++b) {
    if (points_[b].empty()) continue;
    const mechanics::Body& body = *elasticity_.model().bodies[b];
    const BodyState& state = elasticity_.states()[b];
    points_[b].set_time(t);
    points_[b].add_increment(0, end, state.stress, state_.data() + layout_.offset(b),
                             change.data() + layout_.offset(b));
    const mechanics::ElasticState elastic = body.elastic();
    const std::span<const double> weights = body.discretization().weights();
    const auto stress = [&](std::size_t p) { return Eigen::Map<const Tensor6>(state.stress.data() + 6 * p); };
    const double stored = numerics::sum_over_points(
        points_[b].size(), [&](std::size_t p) { return weights[p] * elastic_work(stress(p), elastic.at(p)); });
    const double spent = numerics::sum_over_points(points_[b].size(), [&](std::size_t p) {
      const double* creep = change.data() + layout_.offset(b) + p * layout_.stride(b);
      return weights[p] * stress(p).dot(Eigen::Map<const Tensor6>(creep));
    });
    const double strains = spent / stored;
    if (!(strains > most_creep) || !std::isfinite(strains)) continue;
    mistakes += fmt::format(
        "{}body '{}' would relax in {:.1g} of the run: under its typical stress of {:.3g} at t = {:.6g}, material '{}' "
        "creeps by {:.1g} times its elastic strain until time.end; check that young_modulus, the loads and the creep "
        "constants are in the same units",
        mistakes.empty() ? "" : "\n", body.name(), 1 / strains, StressScale::typical(state), t, body.material().name,
        strains);
  }
  if (!mistakes.empty()) throw ModelError(mistakes);
}

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
