#include "creepcontact/material/plasticity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace creepcontact::material {
namespace {

constexpr int max_newton_steps = 100;
constexpr double newton_tolerance = 1e-14;  // of the yield stress
constexpr double on_surface = 1e-9;         // of the yield stress: nearer than this is on it

double equivalent(const Tensor6& deviator) {
  return std::sqrt(1.5) * deviator.norm();
}

/// (1 - exp(-gamma D))/gamma and exp(-gamma D)
struct Decay {
  Decay(double gamma, double D) : kept(std::exp(-gamma * D)), length(gamma > 0 ? -std::expm1(-gamma * D) / gamma : D) {}
  double kept, length;
};

Plasticity::YieldStress of_curve(const YieldCurve& curve, double p) {
  const auto above = std::ranges::upper_bound(curve.plastic_strain, p);
  const auto i = static_cast<std::size_t>(above - curve.plastic_strain.begin());
  if (i == 0) return {curve.stress.front(), 0};
  if (i == curve.stress.size()) return {curve.stress.back(), 0};
  const double slope =
      (curve.stress[i] - curve.stress[i - 1]) / (curve.plastic_strain[i] - curve.plastic_strain[i - 1]);
  return {curve.stress[i - 1] + slope * (p - curve.plastic_strain[i - 1]), slope};
}

/// Direction in which the way from xi to xi + d first yields, J = 1.
Tensor6 first_direction(const Tensor6& xi, const Tensor6& d, double yield) {
  const double before = equivalent(xi), along = 1.5 * xi.dot(d), length = 1.5 * d.squaredNorm();
  double part = 0;
  if (before < (1 - on_surface) * yield) {
    // length a^2 + 2 along a + before^2 - yield^2 = 0
    const double c = before * before - yield * yield;
    const double root = std::sqrt(std::max(0.0, along * along - length * c));
    part = along > 0 ? -c / (along + root) : (root - along) / length;
  } else if (along < 0) {
    // Through the elastic range to its other side, from its surface or from outside, where the yield stress has fallen;
    // what misses it yields where it comes nearest.
    const double c = before <= (1 + on_surface) * yield ? 0 : before * before - yield * yield;
    part = (-along + std::sqrt(std::max(0.0, along * along - length * c))) / length;
  }
  const Tensor6 at = xi + std::clamp(part, 0.0, 1.0) * d;
  const double at_size = equivalent(at);
  if (!(at_size > 0)) return (xi + d) / equivalent(xi + d);
  return at / at_size;
}

}  // namespace

Plasticity::Plasticity(Function yield_stress, Function hardening_modulus, std::vector<BackStress> back_stresses)
    : initial_(std::move(yield_stress)),
      modulus_(std::move(hardening_modulus)),
      back_stresses_(std::move(back_stresses)) {}

Plasticity::Plasticity(std::vector<YieldCurve> curves, std::vector<BackStress> back_stresses)
    : curves_(std::move(curves)), back_stresses_(std::move(back_stresses)) {}

bool Plasticity::depends_on_temperature() const {
  return curves_.size() > 1 || initial_.depends_on_temperature() || modulus_.depends_on_temperature() ||
         std::ranges::any_of(back_stresses_, [](const BackStress& back) {
           return back.C.depends_on_temperature() || back.gamma.depends_on_temperature();
         });
}

void Plasticity::evaluate(double T, std::span<double> into) const {
  const auto take = [&](std::size_t i, const Function& of, const char* what, bool may_be_zero) {
    const double value = of({.T = T});
    if (!std::isfinite(value) || value < 0 || (value == 0 && !may_be_zero))
      throw std::invalid_argument(fmt::format("plasticity: {} is {:g} at the temperature {:g}; allowed: {}", what,
                                              value, T, may_be_zero ? "numbers >= 0" : "numbers > 0"));
    into[i] = value;
  };
  if (curves_.empty()) {
    take(0, initial_, "yield_stress", false);
    take(1, modulus_, "hardening_modulus", true);
  }
  for (std::size_t i = 0; i < n_back(); ++i) {
    take(2 + 2 * i, back_stresses_[i].C, "C of a back stress", true);
    take(3 + 2 * i, back_stresses_[i].gamma, "gamma of a back stress", true);
  }
}

Plasticity::YieldStress Plasticity::yield_stress(double accumulated, double T,
                                                 std::span<const double> constants) const {
  if (curves_.empty()) return {constants[0] + constants[1] * accumulated, constants[1]};
  const auto above = std::ranges::upper_bound(curves_, T, {}, &YieldCurve::temperature);
  if (above == curves_.begin()) return of_curve(curves_.front(), accumulated);
  if (above == curves_.end()) return of_curve(curves_.back(), accumulated);
  const YieldCurve &cold = *std::prev(above), &hot = *above;
  const double part = (T - cold.temperature) / (hot.temperature - cold.temperature);
  const YieldStress a = of_curve(cold, accumulated), b = of_curve(hot, accumulated);
  return {std::lerp(a.stress, b.stress, part), std::lerp(a.slope, b.slope, part)};
}

Tensor6 Plasticity::back_stress(std::span<const double> back, std::span<const double> constants) const {
  Tensor6 sum = Tensor6::Zero();
  for (std::size_t i = 0; i < n_back() && !back.empty(); ++i)
    sum += 2.0 / 3.0 * constants[2 + 2 * i] * tensor::view(back, i);
  return sum;
}

double Plasticity::hardening(double accumulated, const Tensor6& direction, double T, std::span<const double> constants,
                             std::span<const double> back) const {
  double H = yield_stress(accumulated, T, constants).slope;
  for (std::size_t i = 0; i < n_back(); ++i) {
    const double C = constants[2 + 2 * i], gamma = constants[3 + 2 * i];
    H += C - (back.empty() ? 0 : gamma * 2.0 / 3.0 * C * direction.dot(tensor::view(back, i)));
  }
  return std::max(H, 0.0);
}

PlasticFlowStep Plasticity::flow(const PlasticPoint& from, const Tensor6& trial, double shear_modulus, double T,
                                 std::span<const double> constants, std::span<double> back) const {
  std::ranges::fill(back, 0.0);
  std::ranges::copy(from.back, back.begin());
  const double p = from.accumulated;
  const YieldStress before = yield_stress(p, T, constants);
  const Tensor6 X = back_stress(from.back, constants);
  const double trial_size = equivalent(trial - X);
  if (trial_size <= before.stress) return {};
  const Tensor6 xi = from.stress_deviator - X;
  const Tensor6 first = first_direction(xi, trial - X - xi, before.stress);

  const auto C = [&](std::size_t i) { return constants[2 + 2 * i]; };
  const auto gamma = [&](std::size_t i) { return constants[3 + 2 * i]; };
  // b: twice the mean of what remains at the first yield and at the end; f = J(b) - sy - g/2 falls with D
  Tensor6 b;
  double g = 0;
  const auto excess = [&](double D) {
    g = 3 * shear_modulus * D;
    double g_slope = 3 * shear_modulus;
    b = trial;
    Tensor6 b_slope = Tensor6::Zero();
    for (std::size_t i = 0; i < n_back(); ++i) {
      const Decay decay(gamma(i), D);
      const Tensor6 X_i = 2.0 / 3.0 * C(i) * tensor::view(back, i);
      b -= decay.kept * X_i;
      b_slope += gamma(i) * decay.kept * X_i;
      g += C(i) * decay.length;
      g_slope += C(i) * decay.kept;
    }
    b -= 0.5 * g * first;
    b_slope -= 0.5 * g_slope * first;
    const YieldStress yield = yield_stress(p + D, T, constants);
    const double b_size = equivalent(b);
    const double slope = 1.5 * b.dot(b_slope) / b_size - yield.slope - 0.5 * g_slope;
    return std::pair(b_size - yield.stress - 0.5 * g, slope);
  };
  double sum_of_C = 0;
  for (std::size_t i = 0; i < n_back(); ++i) sum_of_C += C(i);
  double low = 0, high = std::numeric_limits<double>::infinity();
  double D = (trial_size - before.stress) / (3 * shear_modulus + sum_of_C + before.slope);
  for (int step = 0; step < max_newton_steps; ++step) {
    const auto [value, slope] = excess(D);
    if (std::abs(value) <= newton_tolerance * (before.stress + trial_size)) break;
    (value > 0 ? low : high) = D;
    if (std::isfinite(high) && !(high - low > newton_tolerance * high)) break;
    const double newton = slope < 0 ? D - value / slope : low;
    const bool is_inside = newton > low && newton < high;
    D = is_inside ? newton : std::isfinite(high) ? 0.5 * (low + high) : 2 * D;
  }
  excess(D);
  const Tensor6 mean = 0.5 * (first + b / equivalent(b));
  for (std::size_t i = 0; i < n_back(); ++i) {
    const Decay decay(gamma(i), D);
    tensor::writable(back, i) = decay.kept * tensor::view(back, i) + 1.5 * decay.length * mean;
  }
  return {1.5 * D * mean, D};
}

}  // namespace creepcontact::material
