#pragma once
/// Reads temperatures at points: CSV tables, .vtu of ParaView, .frd of CalculiX, or HDF5 with the datasets coordinates
/// (n x 3), temperature (n, or n_times x n) and times (n_times).

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "creepcontact/io/tables/thousands.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::io {

/// Temperatures at points and times.
struct PointTemperatures {
  /// What the coordinates of the points are: with `xy` z is 0, with `rz` they are (r, z, 0).
  enum class Coordinates { xyz, xy, rz };

  std::vector<Vector3> points;  ///< no two equal, sorted
  Coordinates coordinates = Coordinates::xyz;
  std::vector<double> times;                ///< increasing; a single 0 if the file has no times
  bool has_times = false;                   ///< the file says them
  std::vector<std::vector<double>> values;  ///< [time][point]
};

/// Names of columns by what they hold: "x", "y", "z", "r", "t", "T". The others are found by their names.
using ColumnNames = std::map<std::string, std::string>;

/// Temperatures in one file or in one per time.
struct TemperatureSource {
  /// At least one. The name of a single one may have a '*': all files of that form; the number there is the time.
  std::vector<std::filesystem::path> files;
  std::vector<double> times = {};         ///< of the files, one each, increasing; empty: those that the files say
  ColumnNames columns = {};               ///< of CSV tables; "T" also names the array of a .vtu
  Thousands thousands = Thousands::none;  ///< what separates them in CSV tables
};

/// The extension of a file decides: .h5 and .hdf5 are HDF5, .vtu and .frd what they say, all others CSV. Columns,
/// arrays and datasets that are not needed are ignored. A point given twice with the same temperature counts once;
/// nodes of a mesh (.vtu, .frd) at the same place count as one with their mean.
/// @throws ModelError naming the file and, for CSV and .frd, the line
PointTemperatures read_temperatures(const TemperatureSource& source);

/// The files of a source, those of a pattern in the order of their times. @throws ModelError if there is none of that
/// form
std::vector<std::filesystem::path> temperature_files(const TemperatureSource& source);

/// Like read_temperatures(), from the text of a CSV table. @param name  name of the file, for messages
PointTemperatures parse_temperatures(std::string_view text, const std::string& name, const ColumnNames& columns = {},
                                     Thousands thousands = Thousands::none);

}  // namespace creepcontact::io
