#pragma once
/// The [temperature] table of a configuration, applied to the model.

#include <optional>

#include "creepcontact/model/model.hpp"

namespace creepcontact::model {

/// Temperatures in files whose points are the nodes of the mesh (all corners of a body, to the digits of the files) are
/// nodal values, between which the elements of the body interpolate. Points that are not nodes are left out then,
/// unless they are so many that they describe the temperature better than the nodes do.
/// @param mesh  of all bodies @throws ModelError if the file of temperatures cannot be used
mechanics::TemperatureField temperature_field(const config::Temperature& temperature, const mesh::Mesh& mesh);

/// Tells for which bodies the temperatures of files are nodal values, and warns of bodies that have most of them only.
void tell_interpolation(const config::Config& config, const std::vector<mechanics::Body>& bodies,
                        const mechanics::TemperatureField& temperature);

/// If nodes lie far outside the points of temperature files: one warning that tells how many, how far, and where.
void warn_of_positions_outside(const config::Config& config, const std::vector<mechanics::Body>& bodies,
                               const mechanics::TemperatureField& temperature);

/// Minimum and maximum temperature over all integration points at t = 0, the breakpoints, the output times and the end;
/// nullopt without a temperature.
std::optional<Interval> temperature_range(const config::Config& config, const Model& model);

}  // namespace creepcontact::model
