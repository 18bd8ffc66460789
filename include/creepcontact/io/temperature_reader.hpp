#pragma once
/// Reads temperatures at points: a CSV table with the columns x, y, z, T or x, y, z, t, T, or HDF5 with the datasets
/// coordinates (n x 3), temperature (n, or n_times x n) and times (n_times).

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::io {

/// Temperatures at points and times.
struct PointTemperatures {
  std::vector<Vector3> points;              ///< no two equal
  std::vector<double> times;                ///< increasing; a single 0 if the file has no times
  std::vector<std::vector<double>> values;  ///< [time][point]
};

/// The extension decides: .h5 and .hdf5 are HDF5, all others CSV. Other columns and datasets are ignored. A point given
/// twice with the same temperature counts once.
/// @throws ModelError naming the file and, for CSV, the line
PointTemperatures read_temperatures(const std::filesystem::path& file);

/// Like read_temperatures(), from the text of a CSV table. @param name  name of the file, for messages
PointTemperatures parse_temperatures(std::string_view text, const std::string& name);

}  // namespace creepcontact::io
