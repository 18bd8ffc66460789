#include "creepcontact/io/fields/field_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>

#include "../file_text.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/io/fields/vtk_cells.hpp"
#include "vtu_file.hpp"

namespace creepcontact::io {
namespace {

std::vector<std::string> component_names(const pugi::xml_node& array) {
  std::vector<std::string> names;
  while (const auto name = array.attribute(fmt::format("ComponentName{}", names.size()).c_str()))
    names.emplace_back(name.as_string());
  return names;
}

const mesh::CellType* type_of(double vtk_number) {
  const auto& types = mesh::cell_types();
  const auto found =
      std::ranges::find_if(types, [&](mesh::CellType type) { return vtk_cell_type(type) == vtk_number; });
  return found == types.end() ? nullptr : &*found;
}

/// Appends a cell to the last block, or to a new one if that has another type.
void append(mesh::CellType type, const double* vtk_nodes, std::vector<mesh::CellBlock>& blocks) {
  if (blocks.empty() || blocks.back().type != type) blocks.push_back({type, {}});
  std::vector<std::int64_t>& nodes = blocks.back().connectivity;
  const std::span<const int> order = vtk_order(type);
  const std::size_t first = nodes.size();
  nodes.resize(first + order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    nodes[first + static_cast<std::size_t>(order[i])] = static_cast<std::int64_t>(vtk_nodes[i]);
}

}  // namespace

std::vector<FieldEntry> parse_field_list(std::string_view text, const std::filesystem::path& directory,
                                         const std::string& name) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
  const pugi::xml_node list = document.child("VTKFile").child("Collection");
  if (!parsed || !list) throw ConfigError(fmt::format("'{}' is not a list of field files", name));
  std::vector<FieldEntry> entries;
  for (const pugi::xml_node& entry : list.children("DataSet"))
    entries.push_back({entry.attribute("timestep").as_double(), directory / entry.attribute("file").as_string()});
  return entries;
}

std::vector<FieldEntry> read_field_list(const std::filesystem::path& list) {
  return parse_field_list(file_text<ConfigError>(list), list.parent_path(), list.string());
}

struct FieldFile::Content {
  Content(std::string bytes, std::string name)
      : text(std::move(bytes)), file(text, std::move(name), "fields"), piece(file.grid().child("Piece")) {
    if (!piece) file.fail("it has no piece");
    n_points = piece.attribute("NumberOfPoints").as_ullong();
    n_cells = piece.attribute("NumberOfCells").as_ullong();
  }

  pugi::xml_node array(const char* of, const std::string& name) const {
    for (const pugi::xml_node& candidate : piece.child(of).children("DataArray"))
      if (candidate.attribute("Name").as_string() == name) return candidate;
    return {};
  }

  std::string text;
  VtuFile file;
  pugi::xml_node piece;
  std::size_t n_points = 0, n_cells = 0;
};

FieldFile::FieldFile(const std::filesystem::path& path) : FieldFile(file_text<ModelError>(path), path.string()) {}
FieldFile::FieldFile(std::string text, std::string name)
    : content_(std::make_unique<const Content>(std::move(text), std::move(name))) {}
FieldFile::~FieldFile() = default;
FieldFile::FieldFile(FieldFile&&) noexcept = default;
FieldFile& FieldFile::operator=(FieldFile&&) noexcept = default;

std::size_t FieldFile::n_points() const {
  return content_->n_points;
}

std::size_t FieldFile::n_cells() const {
  return content_->n_cells;
}

FieldMesh FieldFile::mesh() const {
  const VtuFile& file = content_->file;
  const std::size_t n = content_->n_points, n_cells = content_->n_cells;
  FieldMesh mesh;
  const std::vector<double> x = file.numbers(content_->piece.child("Points").child("DataArray"), n, 3);
  mesh.points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) mesh.points.emplace_back(x[3 * i], x[3 * i + 1], x[3 * i + 2]);

  const std::vector<double> types = file.numbers(content_->array("Cells", "types"), n_cells, 1),
                            ends = file.numbers(content_->array("Cells", "offsets"), n_cells, 1);
  const double n_corners = n_cells == 0 ? 0 : ends.back();
  if (!(n_corners >= 0 && n_corners <= 27.0 * static_cast<double>(n_cells))) file.fail("the offsets are damaged");
  const std::vector<double> nodes =
      file.numbers(content_->array("Cells", "connectivity"), static_cast<std::size_t>(n_corners), 1);
  for (const double node : nodes)
    if (!(node >= 0 && node < static_cast<double>(n))) file.fail("a cell refers to a point that does not exist");
  double begin = 0;
  for (std::size_t c = 0; c < n_cells; ++c) {
    const mesh::CellType* type = type_of(types[c]);
    if (type == nullptr) file.fail(fmt::format("cells of VTK's type {} are not known", types[c]));
    if (ends[c] - begin != mesh::n_nodes(*type) || ends[c] > n_corners) file.fail("the offsets are damaged");
    append(*type, nodes.data() + static_cast<std::size_t>(begin), mesh.blocks);
    begin = ends[c];
  }
  for (const pugi::xml_node& array : file.grid().child("FieldData").children("DataArray"))
    if (std::vector<std::string> values = component_names(array); !values.empty())
      mesh.texts.push_back({array.attribute("Name").as_string(), std::move(values)});
  return mesh;
}

std::vector<FieldArray> FieldFile::point_arrays() const {
  std::vector<FieldArray> arrays;
  for (const pugi::xml_node& array : content_->piece.child("PointData").children("DataArray"))
    arrays.push_back(
        {array.attribute("Name").as_string(), array.attribute("NumberOfComponents").as_int(1), component_names(array)});
  return arrays;
}

std::vector<double> FieldFile::point_values(const std::string& name) const {
  const pugi::xml_node array = content_->array("PointData", name);
  if (!array) content_->file.fail(fmt::format("there is no array '{}'", name));
  return content_->file.numbers(array, content_->n_points, array.attribute("NumberOfComponents").as_int(1));
}

}  // namespace creepcontact::io
