#include "creepcontact/model/load_cycles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/creep/elastic_survey.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {
namespace {

constexpr double same_time = 1e-9;  // of the period
constexpr double same_load = 1e-7;  // of the largest value in two cycles
constexpr double no_jump = 1e-9;    // of the value
constexpr const char* once = "a support or a preload that acts from or until some time";

}  // namespace

LoadCycles::LoadCycles(const config::Config& config, std::vector<ChangingValue> values, std::vector<double> breakpoints)
    : period_(config.time.cycle.value()), breakpoints_(std::move(breakpoints)), parts_(std::move(values)) {
  const auto n_cycles = static_cast<std::int64_t>(std::floor(config.time.end / period_ + same_time));
  for (std::int64_t k = 1; k <= n_cycles; ++k) {
    const double t = static_cast<double>(k) * period_;
    const auto after = std::ranges::lower_bound(breakpoints_, t - same_time * period_);
    const bool is_breakpoint = after != breakpoints_.end() && *after <= t + same_time * period_;
    ends_.push_back(is_breakpoint ? *after : config.time.end);
  }
  for (const config::Support& support : config.supports)
    for (const auto& time : {support.from, support.until})
      if (time) sudden_.push_back(*time);
  for (const config::Contact& contact : config.contacts)
    if (contact.preload) sudden_.push_back(contact.preload->time);
  Samples before;
  for (std::int64_t cycle = 0; cycle < count(); ++cycle) {
    Samples now = samples(cycle);
    differences_.push_back(cycle == 0 ? "the start" : difference(now, before));
    before = std::move(now);
  }
  // What begins or ends to act once makes the cycle unlike its neighbours, whatever its breakpoints are.
  for (std::int64_t cycle = 0; cycle < count(); ++cycle)
    for (const double t : sudden_)
      if (begin(cycle) <= t && t < end(cycle))
        for (std::int64_t k = cycle; k <= cycle + (t > begin(cycle) ? 1 : 0) && k < count(); ++k)
          differences_[static_cast<std::size_t>(k)] = once;
}

std::optional<std::int64_t> LoadCycles::ending_at(double t) const {
  const auto found = std::ranges::lower_bound(ends_, t);
  if (found == ends_.end() || *found != t) return std::nullopt;
  return found - ends_.begin();
}

std::vector<double> LoadCycles::corners(std::int64_t cycle) const {
  std::vector<double> result{begin(cycle)};
  for (auto next = std::ranges::upper_bound(breakpoints_, begin(cycle));
       next != breakpoints_.end() && *next < end(cycle); ++next)
    result.push_back(*next);
  result.push_back(end(cycle));
  return result;
}

std::vector<double> LoadCycles::values(const ChangingValue& part, double t) {
  std::vector<double> result;
  for (const auto& course : part.courses) result.push_back(course(t));
  return result;
}

LoadCycles::Samples LoadCycles::samples(std::int64_t cycle) const {
  const std::vector<double> at = corners(cycle);
  Samples result;
  for (const double t : at) result.corners.push_back(t - begin(cycle));
  constexpr int regular = 48;  // also at times that do not depend on the breakpoints, of which some may be missing
  for (const ChangingValue& part : parts_) {
    std::vector<double>& all = result.values.emplace_back();
    for (int i = 0; i < regular; ++i)
      for (const double value : values(part, begin(cycle) + (i + 0.37) / regular * period_)) all.push_back(value);
    for (std::size_t i = 1; i < at.size(); ++i)
      for (const double share : {0.21, 0.52, 0.83})
        for (const double value : values(part, at[i - 1] + share * (at[i] - at[i - 1]))) all.push_back(value);
  }
  return result;
}

std::string LoadCycles::difference(const Samples& one, const Samples& other) const {
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const std::vector<double>&a = one.values[p], &b = other.values[p];
    double largest = 0;
    for (const std::vector<double>* all : {&a, &b})
      for (const double value : *all) largest = std::max(largest, std::abs(value));
    // Where the breakpoints differ in number, the values tell whose they are.
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
      if (!(std::abs(a[i] - b[i]) <= same_load * largest)) return parts_[p].key;
  }
  bool same = one.corners.size() == other.corners.size();
  for (std::size_t i = 0; same && i < one.corners.size(); ++i)
    same = std::abs(one.corners[i] - other.corners[i]) <= same_time * period_;
  return same ? "" : "time.breakpoints";
}

bool LoadCycles::repeats_from(std::int64_t cycle) const {
  return std::all_of(differences_.begin() + cycle, differences_.end(),
                     [](const std::string& key) { return key.empty(); });
}

bool LoadCycles::jumps_at(double t) const {
  if (std::ranges::find(sudden_, t) != sudden_.end()) return true;
  return std::ranges::any_of(parts_, [&](const ChangingValue& part) {
    const std::vector<double> before = values(part, creep::just_before(t)), after = values(part, creep::just_after(t));
    for (std::size_t i = 0; i < before.size(); ++i)
      if (std::abs(after[i] - before[i]) > no_jump * std::max(std::abs(after[i]), std::abs(before[i]))) return true;
    return false;
  });
}

std::vector<double> LoadCycles::distinct_breakpoints() const {
  std::vector<double> result;
  auto next = breakpoints_.begin();
  for (std::int64_t cycle = 0; cycle < count(); ++cycle)
    for (; next != breakpoints_.end() && *next <= end(cycle); ++next)
      if (!repeats(cycle)) result.push_back(*next);
  result.insert(result.end(), next, breakpoints_.end());
  return result;
}

void require_cycles(const config::Config& config, const creep::Assembly& assembly, const LoadCycles& cycles) {
  const auto refuse = [&](const std::string& reason) {
    throw ConfigError(fmt::format("{}{}", config.time.location.prefix(), reason));
  };
  const auto& bodies = assembly.bodies();
  const auto has_memory = [](const mechanics::Body& body) {
    return body.material().creeps() || body.material().plasticity != nullptr;
  };
  if (std::ranges::none_of(bodies, has_memory))
    refuse("'cycle': nothing creeps or yields, and there are no life data, so all cycles are alike; remove 'cycle'");
  if (!config.time.jump_cycles) return;
  for (const contact::Pair& pair : assembly.pairs())
    if (pair.coupling.has_friction())
      refuse(
          fmt::format("'jump_cycles': contact '{}' has friction, whose slip depends on the path of every cycle and "
                      "cannot be extrapolated; remove 'jump_cycles', or the friction",
                      pair.name));
  for (const mechanics::Body& body : bodies)
    for (const auto& law : body.material().creep)
      if (law->is_isochronous())
        refuse(
            fmt::format("'jump_cycles': material '{}' creeps by ageing theory, which gives the state at any time at "
                        "once; remove 'jump_cycles'",
                        body.material().name));
  std::string key;
  for (std::int64_t cycle = 1; cycle < cycles.count(); ++cycle) {
    if (cycles.repeats(cycle)) return;
    key = cycles.difference(cycle);
  }
  if (cycles.count() < 2)
    refuse("'jump_cycles': there is one cycle only up to time.end; remove 'jump_cycles', or set a later end");
  refuse(
      fmt::format("'jump_cycles': no two cycles in turn have the same loads: {} does not repeat with time.cycle = "
                  "{}; give it this period (a table in t with 'period', or an expression of mod(t, {})), or "
                  "remove 'jump_cycles'",
                  key, cycles.period(), cycles.period()));
}

}  // namespace creepcontact::model
