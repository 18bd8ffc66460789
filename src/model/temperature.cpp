#include "creepcontact/model/temperature.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/io/temperature_reader.hpp"

namespace creepcontact::model {

namespace {

/// Points of a solid, or with y and z exchanged, would give temperatures of other places without a word.
void require_plane(const std::vector<Vector3>& points, const std::string& file) {
  constexpr double small = 1e-6;  // of the largest coordinate
  double largest = 0;
  for (const Vector3& x : points) largest = std::max(largest, x.cwiseAbs().maxCoeff());
  for (const Vector3& x : points)
    if (std::abs(x.z()) > small * largest)
      throw ModelError(fmt::format(
          "temperature: '{}' has a point ({:.6g}, {:.6g}, {:.6g}), but the section lies in the plane z = 0; "
          "give the points of the section, with z = 0",
          file, x[0], x[1], x[2]));
}

}  // namespace

mechanics::TemperatureField temperature_field(const config::Temperature& temperature, const mesh::Section& section) {
  if (temperature.file.empty()) return temperature.value;
  io::PointTemperatures read = io::read_temperatures(temperature.file);
  if (section.dimension() == 2) require_plane(read.points, temperature.file.string());
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
