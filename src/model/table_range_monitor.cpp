#include "creepcontact/model/table_range_monitor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/base/log.hpp"
#include "point_extreme.hpp"

namespace creepcontact::model {

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
                            const std::vector<mechanics::BodyConditions>& conditions, const Team& team) {
  if (tables_.empty() || time_ == t || (time_ && !changes_in_time_)) return;
  time_ = t;
  for (std::size_t b = 0; b < bodies.size(); ++b) see(bodies[b], conditions[b], team);
}

void TableRangeMonitor::see(const mechanics::Body& body, const mechanics::BodyConditions& at, const Team& team) {
  const auto found = tables_.find(body.material().name);
  if (found == tables_.end()) return;
  const bool has_temperature = team.any(!at.temperature.empty());
  const double reference = body.material().reference_temperature;
  const PointExtreme hottest = has_temperature ? point_extreme(body, at.temperature, 1, team) : PointExtreme{reference};
  const PointExtreme coldest =
      has_temperature ? point_extreme(body, at.temperature, -1, team) : PointExtreme{reference};
  std::erase_if(found->second, [&](const Table& table) {
    const double margin = point_rounding * std::max(std::abs(table.range.low), std::abs(table.range.high));
    const bool above = hottest[0] > table.range.high + margin;
    if (!above && !(coldest[0] < table.range.low - margin)) return false;
    const PointExtreme& worst = above ? hottest : coldest;
    std::string where = "the reference temperature";
    if (has_temperature)
      where = fmt::format("the temperature at ({:.6g}, {:.6g}, {:.6g}), t = {:.6g},", worst[1], worst[2], worst[3],
                          at.time);
    log::warning("material '{}': {}: {} is {:.6g}, outside its table ({:.6g} .. {:.6g}); the end value is used",
                 found->first, table.what, where, worst[0], table.range.low, table.range.high);
    return true;
  });
  if (found->second.empty()) tables_.erase(found);
}

}  // namespace creepcontact::model
