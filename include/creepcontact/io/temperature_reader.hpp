#pragma once
/// Temperatures at points from a file: a CSV table with the columns x, y, z, T or x, y, z, t, T, or HDF5 with the
/// datasets coordinates (n x 3), temperature (n, or n_times x n) and times (n_times).

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::io {

struct PointTemperatures {
  std::vector<Vector3> points;              ///< no two the same
  std::vector<double> times;                ///< increasing; a single 0 if the file has none
  std::vector<std::vector<double>> values;  ///< one list a time, a value a point
};

/// By the ending: .h5 and .hdf5 are HDF5, everything else is CSV. Other columns and datasets are passed over. A point
/// that stands there twice with one temperature counts once.
/// @throws ModelError naming the file, and the line of a CSV table
PointTemperatures read_temperatures(const std::filesystem::path& file);

/// As read_temperatures(), from the text of a CSV table. @param name  of the file, for messages
PointTemperatures parse_temperatures(std::string_view text, const std::string& name);

}  // namespace creepcontact::io
