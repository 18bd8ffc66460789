#include "vtu_temperatures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <pugixml.hpp>
#include <stdexcept>

#include "creepcontact/base/error.hpp"
#include "point_merging.hpp"
#include "temperature_columns.hpp"
#include "vtk_decoding.hpp"

namespace creepcontact::io {
namespace {

class VtuFile {
 public:
  VtuFile(std::string_view text, std::string name) : name_(std::move(name)) {
    // Raw data may hold anything, also what looks like XML: the document is parsed without them.
    std::string_view xml = text;
    std::string closed;
    if (const std::size_t tag = text.find("<AppendedData"); tag != std::string_view::npos) {
      const std::size_t end = text.find('>', tag), mark = text.find('_', std::min(end, text.size()));
      if (end == std::string_view::npos || mark == std::string_view::npos) fail("the appended data are missing");
      appended_ = text.substr(mark + 1);
      if (const std::size_t last = appended_.rfind("</AppendedData"); last != std::string_view::npos)
        appended_ = appended_.substr(0, last);
      closed = std::string(text.substr(0, end + 1)) + "</AppendedData></VTKFile>";
      xml = closed;
    }
    const pugi::xml_parse_result parsed = document_.load_buffer(xml.data(), xml.size());
    if (!parsed) fail(fmt::format("it is not XML: {}", parsed.description()));
    const pugi::xml_node file = document_.child("VTKFile");
    if (file.attribute("type").as_string() != std::string("UnstructuredGrid"))
      fail(fmt::format("it holds '{}', not an UnstructuredGrid; save it as .vtu", file.attribute("type").as_string()));
    const std::string compressor = file.attribute("compressor").as_string();
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
      fail(fmt::format("its data are compressed by {}; save it with zlib or uncompressed", compressor));
    format_.is_compressed = !compressor.empty();
    format_.has_long_headers = file.attribute("header_type").as_string() == std::string("UInt64");
    format_.is_big_endian = file.attribute("byte_order").as_string() == std::string("BigEndian");
    appended_is_base64_ = file.child("AppendedData").attribute("encoding").as_string() == std::string("base64");
    grid_ = file.child("UnstructuredGrid");
  }

  PointTemperatures temperatures(const std::string& array) const {
    PointTemperatures result;
    result.values.emplace_back();
    result.times.push_back(0);
    for (const pugi::xml_node& piece : grid_.children("Piece")) {
      const std::size_t n = piece.attribute("NumberOfPoints").as_ullong();
      if (n == 0) continue;
      const std::vector<double> x = numbers(piece.child("Points").child("DataArray"), n, 3);
      const std::vector<double> T = numbers(temperature(piece, array), n, 1);
      for (std::size_t i = 0; i < n; ++i) {
        const Vector3 point(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
        if (!point.allFinite() || !std::isfinite(T[i]))
          fail(fmt::format("point {} has coordinates or a temperature that are not finite", i));
        result.points.push_back(point);
        result.values[0].push_back(T[i]);
      }
    }
    if (result.points.empty()) fail("it has no points");
    for (const pugi::xml_node& field : grid_.child("FieldData").children("DataArray"))
      if (field.attribute("Name").as_string() == std::string("TimeValue")) {
        result.times[0] = numbers(field, 1, 1)[0];
        result.has_times = true;
      }
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw ModelError(fmt::format("cannot read temperatures from '{}': {}", name_, what));
  }

  pugi::xml_node temperature(const pugi::xml_node& piece, const std::string& wanted) const {
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
      fail(fmt::format("{} may be the temperature; choose one by columns = {{ T = \"...\" }}{}",
                       fmt::join(fitting, " and "), all));
    for (const pugi::xml_node& array : piece.child("CellData").children("DataArray")) {
      const std::string name = array.attribute("Name").as_string();
      if (wanted.empty() ? quantity_of(name) == "T" : name == wanted)
        fail(fmt::format("'{}' is an array of cells; turn it into one of points (ParaView: Cell Data to Point Data){}",
                         name, all));
    }
    fail((wanted.empty() ? "no array is known as the temperature; name it by columns = { T = \"...\" }"
                         : fmt::format("there is no array '{}'", wanted)) +
         all);
  }

  std::vector<double> numbers(const pugi::xml_node& array, std::size_t n, int components) const {
    const std::string name = array.attribute("Name").as_string();
    try {
      if (!array) throw std::runtime_error("it is missing");
      if (array.attribute("NumberOfComponents").as_int(1) != components)
        throw std::runtime_error(
            fmt::format("{} components instead of {}", array.attribute("NumberOfComponents").as_int(1), components));
      if (n > (std::size_t{1} << 40)) throw std::runtime_error("more points than any file can hold");
      return numbers_of(array, n * static_cast<std::size_t>(components));
    } catch (const std::runtime_error& error) {
      fail(fmt::format("array '{}': {}", name, error.what()));
    }
  }

  std::vector<double> numbers_of(const pugi::xml_node& array, std::size_t n) const {
    const std::string how = array.attribute("format").as_string("ascii"), type = array.attribute("type").as_string();
    if (how == "ascii") return from_text(array.child_value(), n);
    const auto size = vtk_type_size(type);
    if (!size) throw std::runtime_error(fmt::format("numbers of the type '{}' are not supported", type));
    VtkFormat format = format_;
    if (how == "binary") {
      format.is_base64 = true;
      return vtk_numbers(vtk_decode(array.child_value(), n * *size, format), type, format.is_big_endian);
    }
    if (how != "appended") throw std::runtime_error(fmt::format("the format '{}' is unknown", how));
    format.is_base64 = appended_is_base64_;
    const std::size_t offset = array.attribute("offset").as_ullong();
    if (offset > appended_.size()) throw std::runtime_error("its data lie beyond the end of the file");
    return vtk_numbers(vtk_decode(appended_.substr(offset), n * *size, format), type, format.is_big_endian);
  }

  static std::vector<double> from_text(std::string_view text, std::size_t n) {
    std::vector<double> result;
    while (true) {
      text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
      if (text.empty()) break;
      double value = 0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (error != std::errc())
        throw std::runtime_error(
            fmt::format("'{}' is not a number", text.substr(0, text.find_first_of(" \t\r\n")).substr(0, 20)));
      result.push_back(value);
      text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    if (result.size() != n) throw std::runtime_error(fmt::format("{} numbers instead of {}", result.size(), n));
    return result;
  }

  std::string name_;
  pugi::xml_document document_;
  pugi::xml_node grid_;
  std::string_view appended_;
  VtkFormat format_;
  bool appended_is_base64_ = false;
};

}  // namespace

PointTemperatures parse_vtu(std::string_view text, const std::string& name, const std::string& array) {
  return merged(VtuFile(text, name).temperatures(array), name);
}

}  // namespace creepcontact::io
