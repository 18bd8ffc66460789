#include "stress_scale.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace creepcontact::simulation {
namespace {

constexpr double least_share_of_largest = 1e-2;  // of the most stressed body: others need no finer resolution
/// Of the largest stress that the loads give without creep: bodies that carry less are taken to be unloaded.
constexpr double least_share_of_elastic = 1e-3;
constexpr double steady = 0.1;  // relative changes up to here leave the scale as it is

double young_modulus(const material::Moduli& h) {
  return h.mu * (3 * h.lambda + 2 * h.mu) / (h.lambda + h.mu);
}

}  // namespace

StressScale::StressScale(const Model& model, const StateLayout& layout)
    : model_(model), layout_(layout), stress_(model.bodies.size(), 0.0), values_(layout.size(), 1.0) {}

double StressScale::typical(const BodyState& state) {
  constexpr std::size_t piece = 1000;  // summed by one thread: the sum has the same bits for any number of them
  const std::size_t n = state.stress.size() / 6;
  std::vector<double> sums((n + piece - 1) / piece);
#pragma omp parallel for schedule(static) if (n > 2 * piece)
  for (std::size_t i = 0; i < sums.size(); ++i)
    for (std::size_t p = i * piece; p < std::min(n, (i + 1) * piece); ++p) {
      const double q = tensor::von_mises(Eigen::Map<const Tensor6>(state.stress.data() + 6 * p));
      sums[i] += q * q;
    }
  return std::sqrt(std::accumulate(sums.begin(), sums.end(), 0.0) / static_cast<double>(n));
}

void StressScale::set_elastic(const std::vector<double>& stress) {
  const double largest = *std::max_element(stress.begin(), stress.end());
  least_ = least_share_of_elastic * largest;
  for (std::size_t b = 0; b < stress_.size(); ++b) {
    stress_[b] = std::max(stress[b], least_share_of_largest * largest);
    fill(b);
  }
}

void StressScale::follow(const std::vector<BodyState>& states) {
  std::vector<double> stress;
  for (const BodyState& state : states) stress.push_back(typical(state));
  const double largest = *std::max_element(stress.begin(), stress.end());
  for (std::size_t b = 0; b < stress_.size(); ++b) {
    const double now = std::max({stress[b], least_share_of_largest * largest, least_});
    if (!(std::abs(now - stress_[b]) > steady * stress_[b])) continue;
    stress_[b] = now;
    fill(b);
  }
}

void StressScale::restore(const std::vector<double>& stress) {
  stress_ = stress;
  for (std::size_t b = 0; b < stress_.size(); ++b) fill(b);
}

void StressScale::fill(std::size_t body) {
  const mechanics::Body& of = *model_.bodies[body];
  const double strain = stress_[body] / young_modulus(of.elastic().at(0));
  std::vector<double> of_point(std::min<std::size_t>(6, layout_.stride(body)), strain);
  for (const auto& law : of.material().creep)
    for (int k = 0; k < law->n_internal(); ++k)
      of_point.push_back(law->internal_kind(k) == material::InternalKind::fraction ? 1.0 : strain);
  auto at = values_.begin() + static_cast<std::ptrdiff_t>(layout_.offset(body));
  for (std::size_t p = 0; p < of.discretization().n_points(); ++p) at = std::copy(of_point.begin(), of_point.end(), at);
}

}  // namespace creepcontact::simulation
