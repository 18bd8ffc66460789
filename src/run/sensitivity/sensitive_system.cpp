#include "sensitive_system.hpp"

#include <algorithm>
#include <cmath>

namespace creepcontact::run {
SensitiveSystem::SensitiveSystem(Variants& variants)
    : variants_(variants),
      base_(variants.base()),
      n_blocks_(variants.n_values() + 1),
      results_(variants.all().size(), std::vector<double>(base_.size())) {
  set_scale(std::vector<double>(size(), 0.0));
}

void SensitiveSystem::differentiate(std::span<double> blocks, bool adds) const {
  for (std::size_t k = 0; k < variants_.n_values(); ++k) {
    const std::span<double> into = block(blocks, k + 1);
    const std::vector<double>&more = results_[2 * k], &less = results_[2 * k + 1];
    for (std::size_t i = 0; i < into.size(); ++i)
      into[i] = (adds ? into[i] : 0) + Variants::derivative(more[i], less[i]);
  }
}

void SensitiveSystem::rate(double t, std::span<const double> y, std::span<double> rate) {
  variants_.for_each(
      y,
      [&](Variant& variant, std::span<const double> own) {
        variant.system().rate(t, own, results_[Variants::index_of(variant)]);
      },
      [&] { base_.rate(t, block(y, 0), block(rate, 0)); });
  differentiate(rate, false);
}

void SensitiveSystem::set_scale(std::span<const double> y) {
  constexpr double power = 4;  // of the norm
  const double share = std::pow(static_cast<double>(n_blocks_), -1 / power);
  const std::span<const double> of_run = base_.scale();
  const auto size_of = [&](std::size_t i) {
    const std::span<const double> values = block(y, i);
    double largest = 1;
    for (std::size_t j = 0; j < values.size(); ++j) largest = std::max(largest, std::abs(values[j]) / of_run[j]);
    return largest;
  };
  scale_.resize(size());
  const double of_state = size_of(0);
  for (std::size_t i = 0; i < n_blocks_; ++i) {
    const double factor = share * std::max(1.0, size_of(i) / of_state);
    std::ranges::transform(of_run, block(std::span(scale_), i).begin(), [&](double value) { return factor * value; });
  }
}

void SensitiveSystem::accept(double t, std::span<const double> y) {
  std::vector<char> jumped(variants_.all().size(), 0);
  variants_.for_each(
      y,
      [&](Variant& variant, std::span<const double> own) {
        variant.system().accept(t, own);
        jumped[Variants::index_of(variant)] = variant.system().rate_has_jumped() ? 1 : 0;
      },
      [&] { base_.accept(t, block(y, 0)); });
  set_scale(y);
  rate_has_jumped_ = base_.rate_has_jumped() || std::ranges::find(jumped, 1) != jumped.end();
}

void SensitiveSystem::forget_evaluations() {
  base_.forget_evaluations();
  for (const auto& variant : variants_.all()) variant->system().forget_evaluations();
}

void SensitiveSystem::jacobian_times(double t, std::span<const double> y, std::span<const double> v,
                                     std::span<double> product) {
  variants_.for_each(
      y,
      [&](Variant& variant, std::span<const double> own) {
        const std::span<const double> of_run = block(v, 0), of_value = block(v, variant.value() + 1);
        std::vector<double> direction(own.size());
        for (std::size_t i = 0; i < own.size(); ++i)
          direction[i] = of_run[i] + variant.sign() * relative_change * of_value[i];
        variant.system().jacobian_times(t, own, direction, results_[Variants::index_of(variant)]);
      },
      [&] { base_.jacobian_times(t, block(y, 0), block(v, 0), block(product, 0)); });
  differentiate(product, false);
}

void SensitiveSystem::prepare_preconditioner(double t, std::span<const double> y) {
  base_.prepare_preconditioner(t, block(y, 0));
}

void SensitiveSystem::precondition(double gamma, std::span<const double> r, std::span<double> z) {
  for (std::size_t i = 0; i < n_blocks_; ++i) base_.precondition(gamma, block(r, i), block(z, i));
}

void SensitiveSystem::prepare_tangent(double t, std::span<const double> y, double gamma) {
  base_.prepare_tangent(t, block(y, 0), gamma);
}

void SensitiveSystem::solve_tangent(std::span<const double> r, std::span<double> z) {
  for (std::size_t i = 0; i < n_blocks_; ++i) base_.solve_tangent(block(r, i), block(z, i));
}

void SensitiveSystem::start_increment(double t, std::span<const double> y, double stress_time, double duration,
                                      std::span<double> change) {
  variants_.for_each(
      y,
      [&](Variant& variant, std::span<const double> own) {
        std::vector<double>& increment = results_[Variants::index_of(variant)];
        std::ranges::fill(increment, 0.0);
        variant.system().start_increment(t, own, stress_time, duration, increment);
      },
      [&] { base_.start_increment(t, block(y, 0), stress_time, duration, block(change, 0)); });
  differentiate(change, true);
}

}  // namespace creepcontact::run
