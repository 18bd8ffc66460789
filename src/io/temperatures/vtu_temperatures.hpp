#pragma once
/// Temperatures in point data of ParaView's and VTK's unstructured grids (.vtu).

#include <string>
#include <string_view>

#include "creepcontact/io/temperatures/temperature_reader.hpp"

namespace creepcontact::io {

/// Ascii, binary (base64) and appended arrays, raw or compressed by zlib. The time is that of the field data TimeValue,
/// if there is one.
/// @param name  of the file, for messages @param array  of the temperature; empty: the one with a name like it
/// @throws ModelError naming the file
PointTemperatures parse_vtu(std::string_view text, const std::string& name, const std::string& array);

}  // namespace creepcontact::io
