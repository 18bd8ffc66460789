#include "variants.hpp"

#include <fmt/format.h>

#include "../preparation.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"

namespace creepcontact::run {
namespace {

constexpr std::size_t most_at_once = 32;

model::Model with_shared_factors(model::Model model, Kept& kept, linalg::GatheredPasses& passes) {
  model.solver.stiffness_solver = kept.factors.lending(&passes);
  return model;
}

}  // namespace

Variant::Variant(const config::Config& config, double sign, std::size_t value, Kept& kept,
                 linalg::GatheredPasses& passes)
    : sign_(sign),
      value_(value),
      model_(with_shared_factors(model::build_model(config, &kept.meshes), kept, passes)),
      probes_(results::make_probes(config, model_)),
      distribution_(model_.assembly),
      solver_(make_solver(config, model_, distribution_.own(), {}, watch_)),
      system_(make_system(config, model_, solver_, watch_)) {}

void Variant::follow_segment(double begin, double end, std::span<const double> y) {
  const std::pair segment(begin, end);
  if (segment_ == segment) return;
  const bool passes = segment_ && segment_->first != begin;
  segment_ = segment;
  system_.begin_segment(begin, end);
  if (passes) system_.pass_breakpoint(begin, y);
}

void Variant::restore(creep::Memory memory) {
  system_.restore(memory);
  restored_ = std::move(memory);
}

void Variant::resume(double t, std::span<const double> y) {
  if (restored_) system_.resume(t, y, *restored_);
  restored_.reset();
}

Variants::Variants(const std::vector<ChangedValue>& values, creep::CreepSystem& base, Kept& kept,
                   linalg::GatheredPasses& passes)
    : base_(base), passes_(passes), variants_(2 * values.size()), states_(2 * values.size()) {
  // What a variant has to say the run has said already.
  const auto silent = std::make_shared<const log::Sink>([](log::Level, std::string_view) {});
  std::vector<std::function<void()>> jobs;
  for (std::size_t v = 0; v < variants_.size(); ++v)
    jobs.emplace_back([&, v] {
      const log::Redirection nobody(silent);
      const ChangedValue& value = values[v / 2];
      const bool more = v % 2 == 0;
      variants_[v] = std::make_unique<Variant>(more ? value.more : value.less, more ? 1 : -1, v / 2, kept, passes);
    });
  passes_.run(jobs, most_at_once);
}

void Variants::for_each(std::span<const double> whole,
                        const std::function<void(Variant&, std::span<const double> y)>& f,
                        const std::function<void()>& of_base) {
  const std::size_t n = base_.size();
  const double begin = base_.begin_of_segment(), end = base_.end_of_segment();
  std::vector<std::function<void()>> jobs;
  if (of_base) jobs.push_back(of_base);
  for (std::size_t v = 0; v < variants_.size(); ++v) {
    Variant& variant = *variants_[v];
    const std::span<const double> derivative = whole.subspan((variant.value() + 1) * n, n);
    const double change = variant.sign() * relative_change;
    std::vector<double>& y = states_[v];
    y.resize(n);
    for (std::size_t i = 0; i < n; ++i) y[i] = whole[i] + change * derivative[i];
    jobs.emplace_back([&f, &variant, &y, begin, end] {
      variant.follow_segment(begin, end, y);
      f(variant, y);
    });
  }
  passes_.run(jobs, most_at_once);
}

}  // namespace creepcontact::run
