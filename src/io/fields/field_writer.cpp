#include "creepcontact/io/fields/field_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/io/fields/vtk_cells.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "vtk_encoding.hpp"
#include "vtu_document.hpp"

namespace creepcontact::io {
namespace {

EncodedArray encode_points(const std::vector<Vector3>& points) {
  static_assert(sizeof(Vector3) == 3 * sizeof(double));
  return {"Float64", "Points", 3, vtk_encode(std::as_bytes(std::span(points)))};
}

std::vector<EncodedArray> encode_cells(const FieldMesh& mesh) {
  std::vector<std::int64_t> connectivity, offsets;
  std::vector<std::uint8_t> types;
  for (const mesh::CellBlock& block : mesh.blocks) {
    const auto order = vtk_order(block.type);
    types.insert(types.end(), block.size(), vtk_cell_type(block.type));
    for (std::size_t c = 0; c < block.size(); ++c) {
      const auto cell = block.cell(c);
      for (int node : order) connectivity.push_back(cell[node]);
      offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    }
  }
  return {{"Int64", "connectivity", 1, vtk_encode(std::as_bytes(std::span(connectivity)))},
          {"Int64", "offsets", 1, vtk_encode(std::as_bytes(std::span(offsets)))},
          {"UInt8", "types", 1, vtk_encode(std::as_bytes(std::span(types)))}};
}

std::vector<EncodedArray> encode_fields(const std::vector<FieldData>& fields, std::size_t n) {
  std::vector<EncodedArray> result;
  for (const FieldData& field : fields) {
    if (field.components != 1 && field.components != 3 && field.components != 6)
      throw std::invalid_argument(fmt::format("field '{}': {} components", field.name, field.components));
    if (field.values.size() != n * static_cast<std::size_t>(field.components)) {
      throw std::invalid_argument(
          fmt::format("field '{}': {} values for {} x {}", field.name, field.values.size(), n, field.components));
    }
    result.push_back({"Float64", field.name, field.components, vtk_encode(std::as_bytes(std::span(field.values))),
                      field.component_names});
  }
  return result;
}

/// The parts between commas, without blanks around them.
std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) {
    const std::size_t begin = part.find_first_not_of(' '), end = part.find_last_not_of(' ');
    if (begin != std::string::npos) parts.push_back(part.substr(begin, end - begin + 1));
  }
  return parts;
}

}  // namespace

void FieldMesh::append(const mesh::Mesh& body) {
  const auto first = static_cast<std::int64_t>(points.size());
  const auto end_of_cells = body.nodes.begin() + static_cast<std::ptrdiff_t>(body.n_cell_nodes());
  points.insert(points.end(), body.nodes.begin(), end_of_cells);
  for (const mesh::CellBlock& block : body.blocks) {
    if (!body.is_bulk(block.type)) continue;
    blocks.push_back(block);
    for (std::int64_t& node : blocks.back().connectivity) node += first;
  }
}

std::size_t FieldMesh::n_cells() const {
  std::size_t n = 0;
  for (const mesh::CellBlock& block : blocks) n += block.size();
  return n;
}

FieldWriter::FieldWriter(std::filesystem::path directory, std::string name, const FieldMesh& mesh,
                         const std::string& units, Continuation continuation)
    : directory_(std::move(directory)),
      name_(std::move(name)),
      texts_(mesh.texts),
      n_points_(mesh.points.size()),
      n_cells_(mesh.n_cells()),
      points_(encode_points(mesh.points)),
      cells_(encode_cells(mesh)) {
  if (!units.empty()) texts_.insert(texts_.begin(), {"units", words(units)});
  platform::make_inner_directory(directory_ / name_);
  if (continuation.resume) read_collection(continuation.last_time);
}

std::filesystem::path FieldWriter::write(double time, const std::vector<FieldData>& point_data,
                                         const std::vector<FieldData>& cell_data) {
  const std::string file = file_name(first_ + entries_.size());
  platform::replace_file(directory_ / file,
                         vtu_document({time, texts_, n_points_, n_cells_, &points_, &cells_,
                                       encode_fields(point_data, n_points_), encode_fields(cell_data, n_cells_)}),
                         platform::Durable::when_synced);
  unsynced_.push_back(directory_ / file);
  entries_.push_back({time, file});
  write_collection();
  return directory_ / file;
}

std::vector<std::filesystem::path> FieldWriter::take_unsynced() {
  if (!unsynced_.empty()) unsynced_.push_back(list_path());
  return std::exchange(unsynced_, {});
}

std::string FieldWriter::file_name(std::size_t number) const {
  return fmt::format("{0}/{0}_{1:04}.vtu", name_, number);
}

std::filesystem::path FieldWriter::list_path() const {
  return directory_ / (name_ + ".pvd");
}

void FieldWriter::write_collection() {
  pugi::xml_document document;
  pugi::xml_node file = document.append_child("VTKFile");
  file.append_attribute("type") = "Collection";
  file.append_attribute("version") = "1.0";
  pugi::xml_node collection = file.append_child("Collection");
  for (const Entry& entry : entries_) {
    pugi::xml_node node = collection.append_child("DataSet");
    node.append_attribute("timestep") = fmt::format("{}", entry.time).c_str();
    node.append_attribute("part") = 0;
    node.append_attribute("file") = entry.file.c_str();
  }
  std::ostringstream stream;
  document.save(stream, " ");
  std::string text = std::move(stream).str();
  const std::size_t same = std::ranges::mismatch(listed_, text).in1 - listed_.begin();
  const bool longer = !listed_.empty() && text.size() >= listed_.size();
  if (!longer || !platform::rewrite_end(list_path(), same, std::string_view{text}.substr(same)))
    platform::replace_file(list_path(), text, platform::Durable::when_synced);
  listed_ = std::move(text);
}

void FieldWriter::read_collection(double last_time) {
  const std::filesystem::path path = list_path();
  if (!path_exists(path)) {
    log::warning("'{}' of the interrupted run is missing; its fields up to t = {:.6g} will not be listed",
                 path.string(), last_time);
    while (path_exists(directory_ / file_name(first_))) ++first_;  // they are not written over
    return;
  }
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_file(path.c_str());
  const pugi::xml_node collection = document.child("VTKFile").child("Collection");
  if (!parsed || !collection) {
    throw ConfigError(fmt::format("'{}' is not a list of fields: {}; remove it to start a new one", path.string(),
                                  parsed ? "no collection in it" : parsed.description()));
  }
  for (const pugi::xml_node& node : collection.children("DataSet")) {
    const double time = node.attribute("timestep").as_double();
    if (time <= last_time) entries_.push_back({time, node.attribute("file").as_string()});
  }
  write_collection();
}

}  // namespace creepcontact::io
