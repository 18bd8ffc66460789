#include "creepcontact/model/table_range_monitor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/base/log.hpp"

namespace creepcontact::model {
namespace {

constexpr double rounding = 1e-9;  // of temperatures that are interpolated

}  // namespace

TableRangeMonitor::TableRangeMonitor(const config::Config& config) {
  for (const config::ConfiguredFunction& function : config.functions)
    for (const config::Material& material : config.materials)
      if (const std::string table = fmt::format("materials.{}.", material.name); function.key.starts_with(table))
        if (const auto range = function.value.table_range("T"))
          tables_[material.name].push_back({function.key.substr(table.size()), *range});
  // A temperature from a file may change; the field itself will tell.
  changes_in_time_ =
      config.temperature && (!config.temperature->files.empty() || config.temperature->value.depends_on_time());
}

void TableRangeMonitor::see(double t, const std::vector<mechanics::Body>& bodies,
                            const std::vector<mechanics::BodyConditions>& conditions) {
  if (tables_.empty() || time_ == t || (time_ && !changes_in_time_)) return;
  time_ = t;
  for (std::size_t b = 0; b < bodies.size(); ++b) see(bodies[b], conditions[b]);
}

void TableRangeMonitor::see(const mechanics::Body& body, const mechanics::BodyConditions& at) {
  const auto found = tables_.find(body.material().name);
  if (found == tables_.end()) return;
  const std::vector<double>& given = at.temperature;
  const std::span<const double> temperature =
      given.empty() ? std::span<const double>(&body.material().reference_temperature, 1) : given;
  const auto extremes = std::minmax_element(temperature.begin(), temperature.end());
  const auto coldest = extremes.first, hottest = extremes.second;
  std::erase_if(found->second, [&](const Table& table) {
    const double margin = rounding * std::max(std::abs(table.range.low), std::abs(table.range.high));
    const bool above = *hottest > table.range.high + margin;
    if (!above && !(*coldest < table.range.low - margin)) return false;
    const auto worst = above ? hottest : coldest;
    std::string where = "the reference temperature";
    if (!given.empty()) {
      const Vector3& x = body.discretization().point_coordinates()[worst - temperature.begin()];
      where = fmt::format("the temperature at ({:.6g}, {:.6g}, {:.6g}), t = {:.6g},", x[0], x[1], x[2], at.time);
    }
    log::warning("material '{}': {}: {} is {:.6g}, outside its table ({:.6g} .. {:.6g}); the end value is used",
                 found->first, table.what, where, *worst, table.range.low, table.range.high);
    return true;
  });
  if (found->second.empty()) tables_.erase(found);
}

}  // namespace creepcontact::model
