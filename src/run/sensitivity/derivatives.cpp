#include "derivatives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/creep/state_layout.hpp"
#include "difference_derivatives.hpp"
#include "linear_derivatives.hpp"

namespace creepcontact::run {
namespace {

constexpr double same_time = 1e-9;  // relative: rounding of a search

/// @throws ConfigError if states of a model with another value are not near those of the run
void require_nearby(const ChangedValue& value, const model::Model& changed, const model::Model& of_run) {
  if (creep::StateLayout(changed.assembly).size() != creep::StateLayout(of_run.assembly).size())
    throw ConfigError(
        fmt::format("sensitivity.keys: the model has other unknowns with another '{}'; allowed: keys that change "
                    "neither mesh nor laws",
                    value.key));
  const std::vector<double>&times = changed.breakpoints, &of_times = of_run.breakpoints;
  const auto differ = [](double a, double b) {
    return std::abs(a - b) > same_time * std::max(std::abs(a), std::abs(b));
  };
  if (times.size() == of_times.size() && !std::ranges::equal(times, of_times, std::not_fn(differ))) {
    const auto moved = std::ranges::mismatch(times, of_times, std::not_fn(differ));
    throw ConfigError(
        fmt::format("sensitivity.keys: another '{}' moves t = {:.6g}, where something of the model jumps or bends, and "
                    "derivatives are not taken with respect to such times; allowed: keys that change no times",
                    value.key, *moved.in2));
  }
  if (times.size() != of_times.size())
    throw ConfigError(
        fmt::format("sensitivity.keys: with another '{}' the model jumps or bends at other times, and derivatives are "
                    "not taken with respect to times; allowed: keys that change none",
                    value.key));
}

}  // namespace

void require_same_start(const ChangedValue& value, bool of_model, bool of_run) {
  if (of_model == of_run) return;
  throw ConfigError(
      fmt::format("sensitivity.keys: creep begins with an infinite rate on one side of '{}' = {:.6g}, and not on the "
                  "other one: there is no derivative; leave the key out, or give it another value",
                  value.key, value.value));
}

std::unique_ptr<Derivatives> make_derivatives(const std::vector<ChangedValue>& values, const model::Model& model,
                                              creep::CreepSystem& system, creep::EquilibriumSolver& solver, Kept& kept,
                                              linalg::GatheredPasses& passes, Stopwatch& watch) {
  if (!LinearDerivatives::suit(solver)) {
    auto variants = std::make_unique<Variants>(values, system, kept, passes);
    for (const auto& variant : variants->all()) {
      require_nearby(values[variant->value()], variant->model(), model);
      require_same_start(values[variant->value()], variant->system().singular_rate() != nullptr,
                         system.singular_rate() != nullptr);
    }
    return std::make_unique<DifferenceDerivatives>(values, std::move(variants));
  }
  // What these models have to say the run has said already.
  const log::Redirection nobody(std::make_shared<const log::Sink>([](log::Level, std::string_view) {}));
  std::vector<std::unique_ptr<NearbyModel>> models;
  for (const ChangedValue& value : values)
    for (const double sign : {1.0, -1.0}) {
      models.push_back(
          std::make_unique<NearbyModel>(sign > 0 ? value.more : value.less, sign, kept, system.laws().min_strain()));
      require_nearby(value, models.back()->model(), model);
    }
  return std::make_unique<LinearDerivatives>(values, system, solver, std::move(models), watch);
}

}  // namespace creepcontact::run
