#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

#include "creepcontact/base/log.hpp"
#include "discontinuities.hpp"
#include "extrema.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {

std::vector<Vector3> sample_positions(const Bodies& bodies) {
  Eigen::AlignedBox3d box;
  for (const mechanics::Body& body : bodies)
    for (const Vector3& node : body.mesh().nodes) box.extend(node);
  std::vector<Vector3> positions;
  for (const Vector3& share :
       {Vector3(0.31, 0.57, 0.43), Vector3(0.73, 0.21, 0.83), Vector3(0.11, 0.91, 0.67), Vector3(0.89, 0.67, 0.13)})
    positions.emplace_back(box.min() + share.cwiseProduct(box.sizes()));
  return positions;
}

namespace {

/// Each stands for all within its tolerance, the first given counts.
class Times {
 public:
  void add(double time, double tolerance) {
    const auto after = times_.lower_bound(time - tolerance);
    if (after == times_.end() || *after > time + tolerance) times_.insert(time);
  }
  const std::set<double>& all() const { return times_; }

 private:
  std::set<double> times_;
};

/// What is looked for in a function: up to `end`, or, if it repeats with time.cycle from the second cycle on, in its
/// first two cycles, which all later ones are like. Samples of a long run would miss what is short.
class RepeatedSearch {
 public:
  RepeatedSearch(const Function& function, const config::Time& time, std::span<const Vector3> positions)
      : cycle_(time.cycle.value_or(time.end)), end_(time.end), repeats_(2 * cycle_ < end_) {
    constexpr std::int64_t most_cycles = 200, phases = 29;
    constexpr double same = 1e-7;  // of the largest value
    const auto n_cycles = static_cast<std::int64_t>(end_ / cycle_);
    const std::int64_t stride = std::max<std::int64_t>(1, n_cycles / most_cycles);
    for (const Vector3& x : positions)
      for (std::int64_t i = 0; repeats_ && i < phases; ++i) {
        const auto value = [&](std::int64_t of_cycle) {
          const double phase = (static_cast<double>(i) + 0.37) / phases;
          return function({.x = x[0], .y = x[1], .z = x[2], .t = (static_cast<double>(of_cycle) + phase) * cycle_});
        };
        const double expected = value(1);
        for (std::int64_t k = 2; repeats_ && k < n_cycles; k += stride) {
          const double found = value(k);
          repeats_ = std::abs(found - expected) <= same * std::max(std::abs(found), std::abs(expected));
        }
      }
  }

  double end() const { return repeats_ ? 2 * cycle_ : end_; }
  /// The times found up to end(), and those that are like them.
  std::vector<double> all(const std::vector<double>& found) const {
    std::vector<double> times;
    for (const double t : found) {
      times.push_back(t);
      for (double k = 1; repeats_ && t > cycle_ && t + k * cycle_ <= end_; ++k) times.push_back(t + k * cycle_);
    }
    return times;
  }

 private:
  double cycle_, end_;
  bool repeats_;
};

}  // namespace

std::vector<double> breakpoints(const config::Config& config, const Bodies& bodies,
                                const std::optional<mechanics::TemperatureField>& temperature) {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon(), near_kink = 1e-11;
  const double end = config.time.end;
  std::vector<Function> functions;  // which may jump, have kinks and extrema anywhere
  for (const config::ConfiguredFunction& function : config.functions)
    if (function.may_depend_on("t") && function.is_of_position_and_time()) functions.push_back(function.value);
  const std::vector<Vector3> positions = sample_positions(bodies);
  // Jumps are known to the last bit, kinks nearly so; turning points to a sample. What is known better comes first.
  Times times;
  std::vector<Discontinuities> found;
  std::vector<RepeatedSearch> searches;
  for (const Function& function : functions) {
    searches.emplace_back(function, config.time, positions);
    found.push_back(find_discontinuities(function, searches.back().end(), positions));
    for (const double t : searches.back().all(found.back().jumps)) times.add(t, rounding * t);
    if (found.back().too_many)
      log::warning(
          "'{}' has too many kinks or jumps in time to find them all; list the important times in time.breakpoints, or "
          "use a table with a period, or {}",
          function.text(),
          config.time.cycle
              ? fmt::format("correct time.cycle = {:g}, with which it does not repeat", *config.time.cycle)
              : "say with time.cycle that it repeats");
  }
  for (const config::Support& support : config.supports)
    for (const auto& time : {support.from, support.until})
      if (time) times.add(*time, rounding * *time);
  for (const double t : config.time.breakpoints) times.add(t, rounding * t);
  for (const config::Contact& contact : config.contacts)
    if (contact.preload) times.add(contact.preload->time, rounding * contact.preload->time);
  for (const config::ConfiguredFunction& function : config.functions)
    for (const double t : function.value.breakpoints(end)) times.add(t, rounding * t);
  if (temperature)
    for (const double t : temperature->breakpoints(end)) times.add(t, rounding * t);
  if (const auto cycle = config.time.cycle)
    for (double k = 1; k * *cycle <= end; ++k) times.add(k * *cycle, rounding * k * *cycle);
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const double t : searches[i].all(found[i].kinks)) times.add(t, near_kink * t);
  for (std::size_t i = 0; i < functions.size(); ++i)
    for (const double t : searches[i].all(extrema(functions[i], searches[i].end())))
      times.add(t, extremum_error(searches[i].end()));
  std::vector<double> result;
  for (const double t : times.all())
    if (t > 0 && t < end) result.push_back(t);
  return result;
}

}  // namespace creepcontact::model
