#include "vtu_temperatures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "../fields/vtu_file.hpp"
#include "point_merging.hpp"
#include "temperature_columns.hpp"

namespace creepcontact::io {
namespace {

pugi::xml_node temperature(const VtuFile& file, const pugi::xml_node& piece, const std::string& wanted) {
  std::vector<std::string> names, fitting;
  pugi::xml_node found;
  for (const pugi::xml_node& array : piece.child("PointData").children("DataArray")) {
    const std::string name = array.attribute("Name").as_string();
    names.push_back(name);
    if (wanted.empty() ? quantity_of(name) != "T" : name != wanted) continue;
    fitting.push_back(name);
    found = array;
  }
  if (fitting.size() == 1) return found;
  const std::string all =
      fmt::format("; the point data are {}", names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")));
  if (fitting.size() > 1)
    file.fail(fmt::format("{} may be the temperature; choose one by columns = {{ T = \"...\" }}{}",
                          fmt::join(fitting, " and "), all));
  for (const pugi::xml_node& array : piece.child("CellData").children("DataArray")) {
    const std::string name = array.attribute("Name").as_string();
    if (wanted.empty() ? quantity_of(name) == "T" : name == wanted)
      file.fail(fmt::format(
          "'{}' is an array of cells; turn it into one of points (ParaView: Cell Data to Point Data){}", name, all));
  }
  file.fail((wanted.empty() ? "no array is known as the temperature; name it by columns = { T = \"...\" }"
                            : fmt::format("there is no array '{}'", wanted)) +
            all);
}

PointTemperatures temperatures(const VtuFile& file, const std::string& array) {
  PointTemperatures result;
  result.values.emplace_back();
  result.times.push_back(0);
  for (const pugi::xml_node& piece : file.grid().children("Piece")) {
    const std::size_t n = piece.attribute("NumberOfPoints").as_ullong();
    if (n == 0) continue;
    const std::vector<double> x = file.numbers(piece.child("Points").child("DataArray"), n, 3);
    const std::vector<double> T = file.numbers(temperature(file, piece, array), n, 1);
    for (std::size_t i = 0; i < n; ++i) {
      const Vector3 point(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
      if (!point.allFinite() || !std::isfinite(T[i]))
        file.fail(fmt::format("point {} has coordinates or a temperature that are not finite", i));
      result.points.push_back(point);
      result.values[0].push_back(T[i]);
    }
  }
  if (result.points.empty()) file.fail("it has no points");
  for (const pugi::xml_node& field : file.grid().child("FieldData").children("DataArray"))
    if (field.attribute("Name").as_string() == std::string("TimeValue")) {
      result.times[0] = file.numbers(field, 1, 1)[0];
      result.has_times = true;
    }
  return result;
}

}  // namespace

PointTemperatures parse_vtu(std::string_view text, const std::string& name, const std::string& array) {
  return merged(temperatures(VtuFile(text, name, "temperatures"), array), name);
}

}  // namespace creepcontact::io
