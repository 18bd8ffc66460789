#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "creepcontact/config/configured.hpp"
#include "function_search.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {

namespace {

/// A set of times. If times lie within a tolerance of each other, only the first that was added is kept.
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

}  // namespace

std::vector<double> breakpoints(const config::Config& config, std::span<const SearchedFunction> functions,
                                const std::optional<mechanics::TemperatureField>& temperature) {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon(), near_kink = 1e-11;
  const double end = config.time.end;
  // Jumps are known to the last bit, kinks nearly so; extrema to a sample. What is known better comes first.
  Times times;
  for (const SearchedFunction& function : functions)
    for (const double t : function.events.jumps) times.add(t, rounding * t);
  for (const config::Support& support : config.supports)
    for (const auto& time : {support.from, support.until})
      if (time) times.add(*time, rounding * *time);
  for (const double t : config.time.breakpoints) times.add(t, rounding * t);
  for (const config::Contact& contact : config.contacts)
    if (contact.preload) times.add(contact.preload->time, rounding * contact.preload->time);
  for (const config::ConfiguredFunction& function : config::functions(config))
    for (const double t : function.value.breakpoints(end)) times.add(t, rounding * t);
  if (temperature)
    for (const double t : temperature->breakpoints(end)) times.add(t, rounding * t);
  if (const auto cycle = config.time.cycle)
    for (double k = 1; k * *cycle <= end; ++k) times.add(k * *cycle, rounding * k * *cycle);
  for (const SearchedFunction& function : functions)
    for (const double t : function.events.kinks) times.add(t, near_kink * t);
  for (const SearchedFunction& function : functions)
    for (const double t : function.passages) times.add(t, near_kink * t);
  for (const SearchedFunction& function : functions)
    for (const Turn& turn : function.events.turns) times.add(turn.time, turn.error);
  std::vector<double> result;
  for (const double t : times.all())
    if (t > 0 && t < end) result.push_back(t);
  return result;
}

}  // namespace creepcontact::model
