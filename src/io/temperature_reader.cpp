#include "creepcontact/io/temperature_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "csv_text.hpp"
#include "file_text.hpp"
#include "hdf5_file.hpp"
#include "temperature_rows.hpp"

namespace creepcontact::io {
namespace {

/// Where the columns x, y, z, T and, if there is one, t stand.
struct Columns {
  std::array<std::size_t, 4> required;
  std::optional<std::size_t> time;
};

Columns find_columns(const std::string& file, const std::vector<std::string>& names) {
  const auto find = [&](std::string_view name) -> std::optional<std::size_t> {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return found - names.begin();
  };
  Columns columns{{}, find("t")};
  constexpr std::array<std::string_view, 4> wanted{"x", "y", "z", "T"};
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const auto found = find(wanted[k]);
    if (!found)
      throw ModelError(fmt::format(
          "'{}', line 1: no column '{}' among {}; the first line names the columns x, y, z, T, or x, y, z, t, T", file,
          wanted[k], fmt::join(names, ", ")));
    columns.required[k] = *found;
  }
  return columns;
}

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
  return rows.sorted();
}

PointTemperatures read_hdf5(const std::filesystem::path& path) {
  const Hdf5Silence silence;
  try {
    return read_datasets(path.string(), open_hdf5(path));
  } catch (const Hdf5Error& error) {
    throw ModelError(fmt::format("'{}' is damaged or not an HDF5 file: {}", path.string(), error.what()));
  }
}

}  // namespace

PointTemperatures parse_temperatures(std::string_view text, const std::string& name) {
  CsvLines lines(text);
  std::string_view line;
  lines.next(line);
  const Columns columns = find_columns(name, csv_cells(line, ','));
  TemperatureRows rows(name, [](std::size_t row) { return fmt::format("line {}", row); });
  for (std::size_t number = 2; lines.next(line); ++number) {
    const std::vector<std::string> row = csv_cells(line, ',');
    if (row.size() == 1 && row[0].empty()) continue;
    const auto value = [&](std::size_t column, std::string_view of) {
      if (column >= row.size())
        throw ModelError(fmt::format("'{}', line {}: {} cells, none in the column '{}'", name, number, row.size(), of));
      double result = 0;
      const char* const end = row[column].data() + row[column].size();
      const auto [stop, error] = std::from_chars(row[column].data(), end, result);
      if (error != std::errc() || stop != end)
        throw ModelError(
            fmt::format("'{}', line {}: '{}' in the column '{}' is not a number", name, number, row[column], of));
      return result;
    };
    const auto& [x, y, z, T] = columns.required;
    rows.add(number, {value(x, "x"), value(y, "y"), value(z, "z")}, columns.time ? value(*columns.time, "t") : 0.0,
             value(T, "T"));
  }
  return rows.sorted();
}

PointTemperatures read_temperatures(const std::filesystem::path& file) {
  if (file.extension() == ".h5" || file.extension() == ".hdf5") {
    if (const std::string reason = why_unreadable(file); !reason.empty())
      throw ModelError(fmt::format("cannot read '{}': {}", file.string(), reason));
    return read_hdf5(file);
  }
  return parse_temperatures(file_text<ModelError>(file), file.string());
}

}  // namespace creepcontact::io
