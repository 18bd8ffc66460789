#pragma once
/// Nodes of a mesh as points of which no two are equal.

#include <string>

#include "creepcontact/io/temperatures/temperature_reader.hpp"

namespace creepcontact::io {

/// Sorts the points, and takes those at the same place, as on both sides of a contact, for one with their mean value. A
/// warning says where they differ.
/// @param read  with any points, and at least one @param file  as the warning names it @param of  what the warning is
/// about: "temperature"
PointTemperatures merged(PointTemperatures read, const std::string& file, const std::string& of = "temperature");

}  // namespace creepcontact::io
