#include "temperature_rows.hpp"

#include <fmt/format.h>

#include <cmath>

#include "creepcontact/base/error.hpp"

namespace creepcontact::io {

void TemperatureRows::add(std::size_t row, const Vector3& position, double time, double temperature) {
  if (!position.allFinite() || !std::isfinite(time) || !std::isfinite(temperature))
    throw ModelError(
        fmt::format("'{}', {}: the number is not finite; every point needs finite coordinates and a finite temperature",
                    file_, row_name_(row)));
  const auto [found, is_new] =
      times_[time].try_emplace({position[0], position[1], position[2]}, Value{temperature, row});
  if (!is_new && found->second.temperature != temperature)
    throw ModelError(fmt::format(
        "'{}', {}: the point ({:.6g}, {:.6g}, {:.6g}) has the temperature {:.6g} here and {:.6g} in {}; give only one",
        file_, row_name_(row), position[0], position[1], position[2], temperature, found->second.temperature,
        row_name_(found->second.row)));
}

PointTemperatures TemperatureRows::sorted() const {
  if (times_.empty()) throw ModelError(fmt::format("'{}' contains no temperatures", file_));
  const std::map<Place, Value>& first = times_.begin()->second;
  PointTemperatures result;
  for (const auto& [position, value] : first) result.points.emplace_back(position[0], position[1], position[2]);
  for (const auto& [time, values] : times_) {
    const auto lacks = [&](const std::map<Place, Value>& here, const std::map<Place, Value>& there, double at) {
      for (const auto& [position, value] : there)
        if (!here.contains(position))
          throw ModelError(
              fmt::format("'{}': the point ({:.6g}, {:.6g}, {:.6g}) of {} is missing at t = {:.6g}; the same positions "
                          "must appear at every time",
                          file_, position[0], position[1], position[2], row_name_(value.row), at));
    };
    lacks(values, first, time);
    lacks(first, values, times_.begin()->first);
    result.times.push_back(time);
    std::vector<double>& list = result.values.emplace_back();
    for (const auto& [position, value] : values) list.push_back(value.temperature);
  }
  return result;
}

}  // namespace creepcontact::io
