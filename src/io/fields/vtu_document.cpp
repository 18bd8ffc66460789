#include "vtu_document.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <pugixml.hpp>
#include <sstream>

namespace creepcontact::io {
namespace {

void add_component_names(pugi::xml_node array, const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i)
    array.append_attribute(fmt::format("ComponentName{}", i).c_str()) = names[i].c_str();
}

/// Adds the arrays to the document; their bytes come at its end, which is not XML. Refers to the arrays.
class Appender {
 public:
  void add(pugi::xml_node parent, const EncodedArray& array) {
    pugi::xml_node node = parent.append_child("DataArray");
    node.append_attribute("type") = array.type.c_str();
    node.append_attribute("Name") = array.name.c_str();
    node.append_attribute("NumberOfComponents") = array.components;
    add_component_names(node, array.component_names);
    node.append_attribute("format") = "appended";
    arrays_.push_back({node.append_attribute("offset"), &array});
  }
  /// Tells the document where the bytes are: those of the array that was added last come first. meshio 5 counts offsets
  /// again from the first bytes on, and takes the first array in the document with an offset, old or new, for the next:
  /// in the order of the document it would now and then take one whose bytes it has read.
  void place() {
    std::reverse(arrays_.begin(), arrays_.end());
    for (auto& [offset, array] : arrays_) {
      offset = static_cast<unsigned long long>(size_);
      size_ += array->data.size();
    }
  }
  /// After place(). @returns the bytes of all arrays between two texts
  std::string between(std::string_view before, std::string_view after) const {
    std::string all;
    all.reserve(before.size() + size_ + after.size());
    all += before;
    for (const auto& placed : arrays_) all += placed.array->data;
    all += after;
    return all;
  }

 private:
  struct Placed {
    pugi::xml_attribute offset;
    const EncodedArray* array;
  };
  std::vector<Placed> arrays_;
  std::size_t size_ = 0;
};

pugi::xml_node add_ascii_array(pugi::xml_node parent, const char* type, const std::string& name,
                               const std::string& data) {
  pugi::xml_node node = parent.append_child("DataArray");
  node.append_attribute("type") = type;
  node.append_attribute("Name") = name.c_str();
  node.append_attribute("NumberOfTuples") = 1;
  node.append_attribute("format") = "ascii";
  node.text() = data.c_str();
  return node;
}

/// Shown by ParaView's information panel and spreadsheet. Words are the names of components, whose values are their
/// numbers: arrays of strings, which VTK has, make other readers (meshio 5) refuse the whole file.
void add_field_data(pugi::xml_node grid, const VtuContent& content) {
  pugi::xml_node fields = grid.append_child("FieldData");
  add_ascii_array(fields, "Float64", "TimeValue", fmt::format("{}", content.time));
  for (const TextArray& text : content.texts) {
    std::vector<std::size_t> numbers(text.values.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    pugi::xml_node node = add_ascii_array(fields, "Int32", text.name, fmt::format("{}", fmt::join(numbers, " ")));
    node.append_attribute("NumberOfComponents") = static_cast<unsigned long long>(text.values.size());
    add_component_names(node, text.values);
  }
}

/// VTK takes any ">" for the end of a tag, also one in an attribute, where XML allows it and pugixml leaves it.
std::string with_escaped_ends(const std::string& xml) {
  std::string text;
  text.reserve(xml.size());
  bool in_value = false;
  for (const char c : xml) {
    if (c == '"') in_value = !in_value;
    if (c == '>' && in_value)
      text += "&gt;";
    else
      text += c;
  }
  return text;
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
  appender.place();

  pugi::xml_node appended = file.append_child("AppendedData");
  appended.append_attribute("encoding") = "raw";
  appended.text() = "_";  // VTK's mark of the beginning; offsets count from behind it
  std::ostringstream stream;
  document.save(stream, " ");
  const std::string text = with_escaped_ends(stream.str());
  const std::size_t end = text.rfind("</AppendedData>");
  // meshio takes a line break for the end of the data.
  return appender.between(text.substr(0, end), "\n " + text.substr(end));
}

}  // namespace creepcontact::io
