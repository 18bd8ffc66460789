#include "creepcontact/simulation/temperature_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/base/log.hpp"

namespace creepcontact::simulation {
namespace {

constexpr double rounding = 1e-9;  // of temperatures that are interpolated

}  // namespace

TemperatureWatch::TemperatureWatch(const config::Config& config) {
  for (const config::Material& material : config.materials) {
    const auto add = [&](const std::string& what, const Function& function) {
      if (const auto range = function.table_range("T")) tables_[material.name].push_back({what, *range});
    };
    add("young_modulus", material.young_modulus);
    add("poisson_ratio", material.poisson_ratio);
    add("thermal_expansion", material.thermal_expansion);
    for (std::size_t i = 0; i < material.creep.size(); ++i)
      for (const config::CreepParameter& parameter : material.creep[i].parameters)
        for (const Function& value : parameter.values) add(fmt::format("creep[{}].{}", i, parameter.key), value);
  }
  // A temperature from a file may change; the field itself will tell.
  changes_in_time_ =
      config.temperature && (!config.temperature->file.empty() || config.temperature->value.depends_on_time());
}

void TemperatureWatch::see(double t, const std::vector<std::unique_ptr<mechanics::Body>>& bodies) {
  if (tables_.empty() || time_ == t || (time_ && !changes_in_time_)) return;
  time_ = t;
  for (const auto& body : bodies) see(t, *body);
}

void TemperatureWatch::see(double t, mechanics::Body& body) {
  const auto found = tables_.find(body.material().name);
  if (found == tables_.end()) return;
  const std::span<const double> given = body.temperature(t);
  const std::span<const double> temperature =
      given.empty() ? std::span<const double>(&body.material().reference_temperature, 1) : given;
  const auto [coldest, hottest] = std::minmax_element(temperature.begin(), temperature.end());
  std::erase_if(found->second, [&](const Table& table) {
    const double margin = rounding * std::max(std::abs(table.range.low), std::abs(table.range.high));
    const bool above = *hottest > table.range.high + margin;
    if (!above && !(*coldest < table.range.low - margin)) return false;
    const auto worst = above ? hottest : coldest;
    std::string where = "the reference temperature";
    if (!given.empty()) {
      const Vector3& x =
          body.discretization().point_coordinates()[static_cast<std::size_t>(worst - temperature.begin())];
      where = fmt::format("the temperature at ({:.6g}, {:.6g}, {:.6g}), t = {:.6g},", x[0], x[1], x[2], t);
    }
    log::warning("material '{}': {}: {} is {:.6g}, outside its table ({:.6g} .. {:.6g}); the end value is used",
                 found->first, table.what, where, *worst, table.range.low, table.range.high);
    return true;
  });
  if (found->second.empty()) tables_.erase(found);
}

}  // namespace creepcontact::simulation
