#include "vtu_document.hpp"

#include <fmt/ranges.h>

#include <bit>
#include <pugixml.hpp>
#include <sstream>

namespace creepcontact::io {
namespace {

/// Adds the arrays to the document and gathers their bytes for its end.
class Appender {
 public:
  void add(pugi::xml_node parent, const EncodedArray& array) {
    pugi::xml_node node = parent.append_child("DataArray");
    node.append_attribute("type") = array.type.c_str();
    node.append_attribute("Name") = array.name.c_str();
    node.append_attribute("NumberOfComponents") = array.components;
    for (std::size_t i = 0; i < array.component_names.size(); ++i)
      node.append_attribute(fmt::format("ComponentName{}", i).c_str()) = array.component_names[i].c_str();
    node.append_attribute("format") = "appended";
    node.append_attribute("offset") = static_cast<unsigned long long>(data_.size() - 1);
    data_ += array.data;
  }
  const std::string& data() const { return data_; }

 private:
  std::string data_ = "_";  // VTK's mark of the beginning; offsets count from behind it
};

/// Shown by ParaView's information panel. Strings are the numbers of their characters, ending in 0.
void add_field_data(pugi::xml_node grid, const VtuContent& content) {
  pugi::xml_node fields = grid.append_child("FieldData");
  pugi::xml_node time = fields.append_child("DataArray");
  time.append_attribute("type") = "Float64";
  time.append_attribute("Name") = "TimeValue";
  time.append_attribute("NumberOfTuples") = 1;
  time.append_attribute("format") = "ascii";
  time.text() = fmt::format("{}", content.time).c_str();
  for (const TextArray& text : content.texts) {
    pugi::xml_node node = fields.append_child("Array");
    node.append_attribute("type") = "String";
    node.append_attribute("Name") = text.name.c_str();
    node.append_attribute("NumberOfTuples") = static_cast<unsigned long long>(text.values.size());
    node.append_attribute("format") = "ascii";
    std::vector<int> codes;
    for (const std::string& value : text.values) {
      for (char c : value) codes.push_back(static_cast<unsigned char>(c));
      codes.push_back(0);
    }
    node.text() = fmt::format("{}", fmt::join(codes, " ")).c_str();
  }
}

}  // namespace

std::string vtu_document(const VtuContent& content) {
  pugi::xml_document document;
  pugi::xml_node file = document.append_child("VTKFile");
  file.append_attribute("type") = "UnstructuredGrid";
  file.append_attribute("version") = "1.0";
  file.append_attribute("byte_order") = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  file.append_attribute("header_type") = "UInt64";
  file.append_attribute("compressor") = "vtkZLibDataCompressor";
  pugi::xml_node grid = file.append_child("UnstructuredGrid");
  add_field_data(grid, content);

  Appender appender;
  pugi::xml_node piece = grid.append_child("Piece");
  piece.append_attribute("NumberOfPoints") = static_cast<unsigned long long>(content.n_points);
  piece.append_attribute("NumberOfCells") = static_cast<unsigned long long>(content.n_cells);
  pugi::xml_node point_data = piece.append_child("PointData");
  for (const EncodedArray& array : content.point_data) appender.add(point_data, array);
  pugi::xml_node cell_data = piece.append_child("CellData");
  for (const EncodedArray& array : content.cell_data) appender.add(cell_data, array);
  appender.add(piece.append_child("Points"), *content.points);
  pugi::xml_node cells = piece.append_child("Cells");
  for (const EncodedArray& array : *content.cells) appender.add(cells, array);

  pugi::xml_node appended = file.append_child("AppendedData");
  appended.append_attribute("encoding") = "base64";
  appended.text() = appender.data().c_str();
  std::ostringstream stream;
  document.save(stream, " ");
  return std::move(stream).str();
}

}  // namespace creepcontact::io
