#pragma once
/// A function of the configuration as a function of time alone.

#include <optional>
#include <span>
#include <vector>

#include "creepcontact/config/configured.hpp"
#include "discontinuities.hpp"
#include "places.hpp"

namespace creepcontact::model {

/// A stress and a creep strain that a function may meet.
struct Level {
  double q = 0, eps = 0;
};

/// Makes courses of one function. The model must outlive it, not the courses.
class FunctionCourses {
 public:
  FunctionCourses(const config::ConfiguredFunction& function, const config::Config& config, const Bodies& bodies,
                  const std::optional<mechanics::TemperatureField>& temperature)
      : function_(function), config_(config), bodies_(bodies), temperature_(temperature) {}

  bool changes_in_time() const;
  bool depends_on_place() const;
  /// True if the temperature that it depends on comes from points, where a single value is expensive.
  bool needs_point_temperatures() const;

  /// The first one is in the middle of the range.
  std::vector<Level> levels(const Place& place) const;
  Course at(const Place& place, const Level& level) const;
  /// The temperature there.
  Course temperature(const Place& place) const;
  /// As a function of the temperature instead of the time, which is 0.
  double at_temperature(const Place& place, const Level& level, double T) const;

 private:
  bool temperature_changes() const;

  const config::ConfiguredFunction& function_;
  const config::Config& config_;
  const Bodies& bodies_;
  const std::optional<mechanics::TemperatureField>& temperature_;
};

}  // namespace creepcontact::model
