#include "creepcontact/model/temperature.hpp"

#include <algorithm>
#include <limits>

#include "creepcontact/base/log.hpp"
#include "creepcontact/io/temperature_reader.hpp"

namespace creepcontact::model {

mechanics::TemperatureField temperature_field(const config::Temperature& temperature) {
  if (temperature.file.empty()) return temperature.value;
  io::PointTemperatures read = io::read_temperatures(temperature.file);
  return mechanics::TemperatureField(
      mechanics::ScatteredTemperatures{std::move(read.points), std::move(read.times), std::move(read.values)});
}

void warn_of_positions_outside(const config::Config& config, const std::vector<mechanics::Body>& bodies,
                               const mechanics::TemperatureField& temperature) {
  double farthest = 0;
  Vector3 position = Vector3::Zero();
  for (const mechanics::Body& body : bodies)
    for (const Vector3& x : body.discretization().point_coordinates())
      if (const double distance = temperature.distance_outside(x); distance > farthest) {
        farthest = distance;
        position = x;
      }
  if (farthest > 0)
    log::warning(
        "temperature: '{}' does not cover the whole model; the worst place is ({:.6g}, {:.6g}, {:.6g}), {:.4g} from "
        "the nearest point, whose value is used there",
        config.temperature->file.string(), position[0], position[1], position[2], farthest);
}

std::optional<Interval> temperature_range(const config::Config& config, const Model& model) {
  if (!model.temperature) return std::nullopt;
  std::vector<double> times = config.time.output;
  times.insert(times.end(), model.breakpoints.begin(), model.breakpoints.end());
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Interval range{infinity, -infinity};
  for (const mechanics::Body& body : model.bodies())
    for (const double t : times) {
      const std::vector<double> values = body.at(t).temperature;
      const auto [low, high] = std::ranges::minmax_element(values);
      range = {std::min(range.low, *low), std::max(range.high, *high)};
      if (!model.temperature->depends_on_time()) break;
    }
  return range;
}

}  // namespace creepcontact::model
