#include "vtu_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

#include "creepcontact/base/error.hpp"

namespace creepcontact::io {
namespace {

std::vector<double> from_text(std::string_view text, std::size_t n) {
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

}  // namespace

VtuFile::VtuFile(std::string_view text, std::string name, std::string purpose)
    : name_(std::move(name)), purpose_(std::move(purpose)) {
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

void VtuFile::fail(const std::string& what) const {
  throw ModelError(fmt::format("cannot read {} from '{}': {}", purpose_, name_, what));
}

std::vector<double> VtuFile::numbers(const pugi::xml_node& array, std::size_t n, int components) const {
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

std::vector<double> VtuFile::numbers_of(const pugi::xml_node& array, std::size_t n) const {
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

}  // namespace creepcontact::io
