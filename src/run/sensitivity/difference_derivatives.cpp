#include "difference_derivatives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace creepcontact::run {
namespace {

std::string name_of(const Variant& variant) {
  return fmt::format("sensitivity.variant{}", Variants::index_of(variant));
}

}  // namespace

DifferenceDerivatives::DifferenceDerivatives(const std::vector<ChangedValue>& values,
                                             std::unique_ptr<Variants> variants)
    : Derivatives(values, variants->base()),
      variants_(std::move(variants)),
      results_(variants_->all().size(), std::vector<double>(base().size())) {}

void DifferenceDerivatives::differentiate(std::span<double> blocks, bool adds) const {
  for (std::size_t k = 0; k < values().size(); ++k) {
    const std::span<double> into = block(blocks, k + 1);
    const std::vector<double>&more = results_[2 * k], &less = results_[2 * k + 1];
    for (std::size_t i = 0; i < into.size(); ++i) into[i] = (adds ? into[i] : 0) + central_difference(more[i], less[i]);
  }
}

void DifferenceDerivatives::rate(double t, std::span<const double> whole, std::span<double> rate) {
  variants_->for_each(
      whole,
      [&](Variant& variant, std::span<const double> own) {
        variant.system().rate(t, own, results_[Variants::index_of(variant)]);
      },
      [&] { base().rate(t, block(whole, 0), block(rate, 0)); });
  differentiate(rate, false);
}

void DifferenceDerivatives::start_increment(double t, std::span<const double> whole, double stress_time,
                                            double duration, std::span<double> change) {
  variants_->for_each(
      whole,
      [&](Variant& variant, std::span<const double> own) {
        std::vector<double>& increment = results_[Variants::index_of(variant)];
        std::ranges::fill(increment, 0.0);
        variant.system().start_increment(t, own, stress_time, duration, increment);
      },
      [&] { base().start_increment(t, block(whole, 0), stress_time, duration, block(change, 0)); });
  differentiate(change, true);
}

void DifferenceDerivatives::jacobian_times(double t, std::span<const double> whole, std::span<const double> v,
                                           std::span<double> product) {
  variants_->for_each(
      whole,
      [&](Variant& variant, std::span<const double> own) {
        const std::span<const double> of_run = block(v, 0), of_value = block(v, variant.value() + 1);
        std::vector<double> direction(own.size());
        for (std::size_t i = 0; i < own.size(); ++i)
          direction[i] = of_run[i] + variant.sign() * relative_change * of_value[i];
        variant.system().jacobian_times(t, own, direction, results_[Variants::index_of(variant)]);
      },
      [&] { base().jacobian_times(t, block(whole, 0), block(v, 0), block(product, 0)); });
  differentiate(product, false);
}

void DifferenceDerivatives::accept(double t, std::span<const double> whole) {
  std::vector<char> jumped(variants_->all().size(), 0);
  variants_->for_each(
      whole,
      [&](Variant& variant, std::span<const double> own) {
        variant.system().accept(t, own);
        jumped[Variants::index_of(variant)] = variant.system().rate_has_jumped() ? 1 : 0;
      },
      [&] { base().accept(t, block(whole, 0)); });
  rate_has_jumped_ = base().rate_has_jumped() || std::ranges::find(jumped, 1) != jumped.end();
}

void DifferenceDerivatives::forget_evaluations() {
  base().forget_evaluations();
  for (const auto& variant : variants_->all()) variant->system().forget_evaluations();
}

void DifferenceDerivatives::pass_breakpoint(double /*t*/, std::span<const double> whole) {
  variants_->for_each(whole, [](Variant&, std::span<const double>) {});
}

void DifferenceDerivatives::follow_loads(double t) {
  variants_->for_each(std::span<const double>(), [&](Variant& variant, std::span<const double> y) {
    variant.system().evaluate_step(t, y);
    variant.system().accept(t, y);
  });
}

std::vector<Derivatives::OfProbes> DifferenceDerivatives::of_probes(double t, std::span<const double> whole) {
  struct Values {
    std::vector<double> probes;
    std::vector<int> closed;
  };
  std::vector<Values> of(variants_->all().size());
  variants_->for_each(whole, [&](Variant& variant, std::span<const double> y) {
    Values& own = of[Variants::index_of(variant)];
    own.probes = variant.with_snapshot(
        t, y, [&](results::Snapshot& snapshot) { return results::probe_values(variant.probes(), snapshot); });
    own.closed = variant.system().evaluate_output(t, y).equilibrium.contact.active;
  });
  std::vector<OfProbes> result(values().size());
  for (std::size_t k = 0; k < values().size(); ++k) {
    const Values &more = of[2 * k], &less = of[2 * k + 1];
    for (std::size_t p = 0; p < more.probes.size(); ++p)
      result[k].derivatives.push_back(central_difference(more.probes[p], less.probes[p]));
    result[k].is_one_sided = more.closed != less.closed;
  }
  return result;
}

void DifferenceDerivatives::save(creep::Memory& memory) const {
  for (const auto& variant : variants_->all()) {
    creep::Memory own;
    variant->save(own);
    memory.add(name_of(*variant), std::move(own));
  }
}

void DifferenceDerivatives::restore(const creep::Memory& memory) {
  for (const auto& variant : variants_->all()) variant->restore(memory.part(name_of(*variant)));
}

void DifferenceDerivatives::resume(double t, std::span<const double> whole) {
  variants_->for_each(whole, [&](Variant& variant, std::span<const double> y) { variant.resume(t, y); });
}

}  // namespace creepcontact::run
