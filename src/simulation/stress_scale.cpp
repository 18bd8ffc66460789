#include "stress_scale.hpp"

#include <algorithm>
#include <cmath>

#include "creepcontact/numerics/point_sums.hpp"

namespace creepcontact::simulation {
namespace {

constexpr double least_share_of_largest = 1e-2;  // of the most stressed body: others need no finer resolution
/// Of the largest stress that the loads give without creep: bodies that carry less are taken to be unloaded.
constexpr double least_share_of_elastic = 1e-3;
constexpr double steady = 0.1;  // relative changes up to here leave the scale as it is

}  // namespace

StressScale::StressScale(const Model& model, const StateLayout& layout)
    : model_(model), layout_(layout), strain_(model.bodies.size(), 0.0), values_(layout.size(), 1.0) {}

double StressScale::typical(const BodyState& state) {
  const std::size_t n = state.stress.size() / 6;
  const double sum = numerics::sum_over_points(n, [&](std::size_t p) {
    const double q = tensor::von_mises(Eigen::Map<const Tensor6>(state.stress.data() + 6 * p));
    return q * q;
  });
  return std::sqrt(sum / static_cast<double>(n));
}

void StressScale::set_elastic(const std::vector<double>& stress) {
  const double largest = *std::max_element(stress.begin(), stress.end());
  least_ = least_share_of_elastic * largest;
  for (std::size_t b = 0; b < strain_.size(); ++b)
    set(b, std::max(stress[b], least_share_of_largest * largest) / young_modulus(b));
}

void StressScale::follow(const std::vector<BodyState>& states) {
  std::vector<double> stress;
  for (const BodyState& state : states) stress.push_back(typical(state));
  const double largest = *std::max_element(stress.begin(), stress.end());
  for (std::size_t b = 0; b < strain_.size(); ++b) {
    const double now = std::max({stress[b], least_share_of_largest * largest, least_}) / young_modulus(b);
    if (std::abs(now - strain_[b]) > steady * strain_[b]) set(b, now);
  }
}

void StressScale::restore(const std::vector<double>& strain) {
  for (std::size_t b = 0; b < strain_.size(); ++b) set(b, strain.at(b));
}

void StressScale::set(std::size_t body, double strain) {
  strain_[body] = strain;
  const mechanics::Body& of = *model_.bodies[body];
  std::vector<double> of_point(std::min<std::size_t>(6, layout_.stride(body)), strain);
  for (const auto& law : of.material().creep)
    for (int k = 0; k < law->n_internal(); ++k)
      of_point.push_back(law->internal_kind(k) == material::InternalKind::fraction ? 1.0 : strain);
  auto at = values_.begin() + static_cast<std::ptrdiff_t>(layout_.offset(body));
  for (std::size_t p = 0; p < of.discretization().n_points(); ++p) at = std::copy(of_point.begin(), of_point.end(), at);
}

double StressScale::young_modulus(std::size_t body) const {
  const material::Moduli& h = model_.bodies[body]->elastic().at(0);
  return h.mu * (3 * h.lambda + 2 * h.mu) / (h.lambda + h.mu);
}

}  // namespace creepcontact::simulation
