#include "creepcontact/io/temperatures/stress_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include "../fields/vtu_file.hpp"
#include "../file_text.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/io/tables/csv_table.hpp"
#include "point_merging.hpp"
#include "temperature_columns.hpp"

namespace creepcontact::io {
namespace {

constexpr std::array components{"xx", "yy", "zz", "xy", "yz", "zx"};

/// The component that a column holds: "Stress_XX [MPa]", "S.S11" and "sigma_xx" are xx. Negative: none.
int component_of(std::string_view column) {
  std::string name;
  for (const char c : column.substr(0, column.find_first_of("[(")))
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  constexpr std::array endings{std::pair("xx", 0), std::pair("yy", 1), std::pair("zz", 2), std::pair("xy", 3),
                               std::pair("yz", 4), std::pair("zx", 5), std::pair("xz", 5), std::pair("11", 0),
                               std::pair("22", 1), std::pair("33", 2), std::pair("12", 3), std::pair("23", 4),
                               std::pair("13", 5), std::pair("31", 5)};
  for (const char* const word : {"", "stress", "sigma", "s", "ss"})
    for (const auto& [ending, component] : endings)
      if (name == fmt::format("{}{}", word, ending)) return component;
  return -1;
}

/// Values at points in the form that merging takes: one list per component.
PointTemperatures six_values() {
  PointTemperatures result;
  result.values.resize(6);
  result.times = {0, 1, 2, 3, 4, 5};
  return result;
}

PointTemperatures of_table(const std::filesystem::path& file, int dimension) {
  const CsvTable table = read_csv_table(file);
  std::array<const std::vector<double>*, 3> place{};
  std::array<const std::vector<double>*, 6> stress{};
  const auto fail = [&](const std::string& what) {
    throw ModelError(fmt::format("'{}': {}; the columns are {}", file.string(), what, fmt::join(table.names, ", ")));
  };
  const auto set = [&](auto& slot, std::size_t column, const char* what) {
    if (slot != nullptr) fail(fmt::format("more than one column of {}", what));
    slot = &table.columns[column];
  };
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    if (const int component = component_of(table.names[i]); component >= 0)
      set(stress[static_cast<std::size_t>(component)], i, components[static_cast<std::size_t>(component)]);
    const std::string quantity = quantity_of(table.names[i]);
    for (std::size_t k = 0; k < 3; ++k)
      if (quantity == std::string(1, "xyz"[k])) set(place[k], i, quantity.c_str());
  }
  const bool is_section = dimension == 2;
  for (std::size_t k = 0; k < 3; ++k)
    if (place[k] == nullptr && !(is_section && k == 2)) fail(fmt::format("no column of {}", "xyz"[k]));
  for (std::size_t i = 0; i < 6; ++i)
    if (stress[i] == nullptr && !(is_section && i >= 4))
      fail(fmt::format("no column of the stress {}; where it is zero, a column of zeros says so", components[i]));
  PointTemperatures result = six_values();
  for (std::size_t row = 0; row < table.rows(); ++row) {
    Vector3 point = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
      if (place[k] != nullptr) point[static_cast<Index>(k)] = (*place[k])[row];
    result.points.push_back(point);
    for (std::size_t i = 0; i < 6; ++i) result.values[i].push_back(stress[i] != nullptr ? (*stress[i])[row] : 0);
  }
  return result;
}

pugi::xml_node stress_array(const VtuFile& file, const pugi::xml_node& piece, int& n_components) {
  std::vector<std::string> names;
  pugi::xml_node found;
  for (const pugi::xml_node& array : piece.child("PointData").children("DataArray")) {
    const std::string name = array.attribute("Name").as_string();
    names.push_back(name);
    const int n = array.attribute("NumberOfComponents").as_int(1);
    if ((n != 6 && n != 9) || !(name == "stress" || name.starts_with("stress ["))) continue;
    n_components = n;
    found = array;
  }
  if (!found)
    file.fail(fmt::format("there is no array 'stress' of six components at the points; the point data are {}",
                          names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
  return found;
}

PointTemperatures of_vtu(const std::filesystem::path& path) {
  const std::string text = file_text<ModelError>(path);
  const VtuFile file(text, path.string(), "stresses");
  constexpr std::array of_nine{0, 4, 8, 1, 5, 2};
  PointTemperatures result = six_values();
  for (const pugi::xml_node& piece : file.grid().children("Piece")) {
    const std::size_t n = piece.attribute("NumberOfPoints").as_ullong();
    if (n == 0) continue;
    int n_components = 6;
    const pugi::xml_node array = stress_array(file, piece, n_components);
    const std::vector<double> x = file.numbers(piece.child("Points").child("DataArray"), n, 3);
    const std::vector<double> stress = file.numbers(array, n, n_components);
    for (std::size_t p = 0; p < n; ++p) {
      result.points.emplace_back(x[3 * p], x[3 * p + 1], x[3 * p + 2]);
      for (std::size_t i = 0; i < 6; ++i) {
        const auto own = n_components == 6 ? i : static_cast<std::size_t>(of_nine[i]);
        result.values[i].push_back(stress[p * static_cast<std::size_t>(n_components) + own]);
      }
    }
  }
  return result;
}

}  // namespace

PointStresses read_stresses(const std::filesystem::path& file, int dimension) {
  const bool is_vtu = file.extension() == ".vtu";
  if (!is_vtu && (file.extension() == ".frd" || file.extension() == ".h5" || file.extension() == ".hdf5"))
    throw ModelError(
        fmt::format("'{}': initial stresses are read from CSV tables and .vtu files; convert it, by "
                    "ParaView for example",
                    file.string()));
  PointTemperatures read = is_vtu ? of_vtu(file) : of_table(file, dimension);
  if (read.points.empty()) throw ModelError(fmt::format("'{}' has no points", file.string()));
  for (std::size_t p = 0; p < read.points.size(); ++p)
    for (const std::vector<double>& component : read.values)
      if (!read.points[p].allFinite() || !std::isfinite(component[p]))
        throw ModelError(
            fmt::format("'{}': point {} has coordinates or a stress that are not finite", file.string(), p + 1));
  read = merged(std::move(read), file.string(), "initial_stress");
  PointStresses result;
  result.points = std::move(read.points);
  for (std::size_t p = 0; p < result.points.size(); ++p) {
    Tensor6& stress = result.stresses.emplace_back();
    for (std::size_t i = 0; i < 6; ++i) stress[static_cast<Index>(i)] = read.values[i][p] * (i < 3 ? 1 : tensor::sqrt2);
  }
  return result;
}

}  // namespace creepcontact::io
