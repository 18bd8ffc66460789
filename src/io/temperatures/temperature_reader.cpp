#include "creepcontact/io/temperatures/temperature_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "../checkpoint/hdf5_file.hpp"
#include "../file_text.hpp"
#include "../tables/csv_text.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/io/tables/csv_table.hpp"
#include "frd_temperatures.hpp"
#include "temperature_columns.hpp"
#include "temperature_files.hpp"
#include "temperature_rows.hpp"
#include "vtu_temperatures.hpp"

namespace creepcontact::io {
namespace {

std::string shape(const std::vector<std::size_t>& extents) {
  return fmt::format("{}", fmt::join(extents, " x "));
}

PointTemperatures read_datasets(const std::string& file, hid_t root) {
  const std::vector<std::string> names = member_names(root);
  const auto has = [&](const char* name) { return std::find(names.begin(), names.end(), name) != names.end(); };
  for (const char* name : {"coordinates", "temperature"})
    if (!has(name))
      throw ModelError(
          fmt::format("'{}': no dataset '{}' among {}; there must be coordinates (n x 3), temperature (n, or n_times x "
                      "n) and, with "
                      "several times, times (n_times)",
                      file, name, fmt::join(names, ", ")));
  const std::vector<std::size_t> positions = extents(root, "coordinates"), given = extents(root, "temperature");
  if (positions.size() != 2 || positions[1] != 3)
    throw ModelError(fmt::format("'{}': 'coordinates' is {}; it must be n x 3", file, shape(positions)));
  const std::vector<double> times = has("times") ? read_array<double>(root, "times") : std::vector<double>{0.0};
  const std::size_t n = positions[0];
  const bool fits = given == std::vector{times.size(), n} || (times.size() == 1 && given == std::vector{n});
  if (!fits)
    throw ModelError(fmt::format("'{}': 'temperature' is {}; with {} points and {} times it must be {} x {}", file,
                                 shape(given), n, times.size(), times.size(), n));
  const auto later = std::adjacent_find(times.begin(), times.end(), [](double a, double b) { return !(a < b); });
  if (later != times.end())
    throw ModelError(fmt::format("'{}': 'times' must increase, but {} follows {}", file, *(later + 1), *later));
  const std::vector<double> x = read_array<double>(root, "coordinates"), T = read_array<double>(root, "temperature");
  TemperatureRows rows(file, [n](std::size_t row) { return fmt::format("point {}, time {}", row % n, row / n); });
  for (std::size_t i = 0; i < T.size(); ++i) {
    const double* position = &x[3 * (i % n)];
    rows.add(i, {position[0], position[1], position[2]}, times[i / n], T[i]);
  }
  PointTemperatures result = rows.sorted();
  result.has_times = has("times");
  return result;
}

PointTemperatures read_hdf5(const std::filesystem::path& path) {
  const Hdf5Silence silence;
  try {
    return read_datasets(path.string(), open_hdf5(path));
  } catch (const Hdf5Error& error) {
    throw ModelError(fmt::format("'{}' is damaged or not an HDF5 file: {}", path.string(), error.what()));
  }
}

PointTemperatures read_one(const std::filesystem::path& file, const ColumnNames& columns, Thousands thousands) {
  const std::filesystem::path kind = file.extension();
  if (kind == ".h5" || kind == ".hdf5") {
    if (const std::string reason = why_unreadable(file); !reason.empty())
      throw ModelError(fmt::format("cannot read '{}': {}", file.string(), reason));
    return read_hdf5(file);
  }
  const std::string text = file_text<ModelError>(file);
  if (kind == ".frd") return parse_frd(text, file.string());
  if (kind != ".vtu") return parse_temperatures(text, file.string(), columns, thousands);
  const auto array = columns.find("T");
  return parse_vtu(text, file.string(), array == columns.end() ? "" : array->second);
}

}  // namespace

PointTemperatures parse_temperatures(std::string_view text, const std::string& name, const ColumnNames& given,
                                     Thousands thousands) {
  CsvLines lines(text);
  std::string_view line;
  lines.next(line);
  const CsvFormat format = csv_format_of(line);
  const TemperatureColumns columns = find_columns(name, csv_cells(line, format.separator), given);
  const PointTemperatures::Coordinates coordinates = columns.coordinates();
  const bool by_radius = coordinates == PointTemperatures::Coordinates::rz;
  TemperatureRows rows(name, [](std::size_t row) { return fmt::format("line {}", row); });
  CsvNumbers numbers(format, thousands, "temperature.thousands =");
  for (std::size_t number = 2; lines.next(line); ++number) {
    const std::vector<std::string> row = csv_cells(line, format.separator);
    if (row.size() == 1 && row[0].empty()) continue;
    const auto value = [&](std::optional<std::size_t> column, std::string_view of) {
      if (!column) return 0.0;
      if (*column >= row.size())
        throw ModelError(fmt::format("'{}', line {}: {} cells, none in the column '{}'", name, number, row.size(), of));
      const CsvNumbers::Reading result = numbers.read(row[*column], number);
      if (!result.value)
        throw ModelError(fmt::format("'{}', line {}: in the column '{}' {}", name, number, of, result.mistake));
      return *result.value;
    };
    const Vector3 place = by_radius ? Vector3(value(columns.r, "r"), value(columns.z, "z"), 0)
                                    : Vector3(value(columns.x, "x"), value(columns.y, "y"), value(columns.z, "z"));
    rows.add(number, place, value(columns.t, "t"), value(columns.T, "T"));
  }
  PointTemperatures result = rows.sorted();
  result.coordinates = coordinates;
  result.has_times = columns.t.has_value();
  return result;
}

std::vector<std::filesystem::path> temperature_files(const TemperatureSource& source) {
  std::vector<std::filesystem::path> paths;
  for (const TimedFile& file : timed_files(source)) paths.push_back(file.path);
  return paths;
}

PointTemperatures read_temperatures(const TemperatureSource& source) {
  const std::vector<TimedFile> files = timed_files(source);
  std::vector<PointTemperatures> read;
  read.reserve(files.size());
  for (const TimedFile& file : files) read.push_back(read_one(file.path, source.columns, source.thousands));
  return joined(files, std::move(read));
}

}  // namespace creepcontact::io
