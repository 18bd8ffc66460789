#pragma once
/// Temperatures in results of CalculiX (.frd, ascii).

#include <string>
#include <string_view>

#include "creepcontact/io/temperatures/temperature_reader.hpp"

namespace creepcontact::io {

/// The nodes and all blocks NDTEMP with their times; of blocks at the same time the last counts.
/// Source: "CalculiX GraphiX", description of the result format.
/// @param name  of the file, for messages @throws ModelError naming the file and the line
PointTemperatures parse_frd(std::string_view text, const std::string& name);

}  // namespace creepcontact::io
