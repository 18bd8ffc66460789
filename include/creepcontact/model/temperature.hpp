#pragma once
/// The [temperature] of a configuration on the model.

#include <optional>

#include "creepcontact/model/model.hpp"

namespace creepcontact::model {

/// @throws ModelError if its file cannot be used
mechanics::TemperatureField temperature_field(const config::Temperature& temperature);

/// One warning with the place farthest outside the points of a temperature file, if there is one.
void warn_of_places_outside(const config::Config& config, const std::vector<mechanics::Body>& bodies,
                            const mechanics::TemperatureField& temperature);

/// Least and largest temperature at the integration points at 0, the breakpoints, the output times and the end.
/// Empty without a temperature.
std::optional<Interval> temperature_range(const config::Config& config, const Model& model);

}  // namespace creepcontact::model
