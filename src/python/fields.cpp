/// Meshes and fields, in memory and of field files.

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <utility>

#include "bindings.hpp"
#include "creepcontact/io/fields/field_reader.hpp"
#include "creepcontact/io/fields/vtk_cells.hpp"
#include "creepcontact/io/tables/csv_table.hpp"

namespace creepcontact::python {
namespace {

py::array_t<double> points_of(const io::FieldMesh& mesh) {
  std::vector<double> values;
  values.reserve(3 * mesh.points.size());
  for (const Vector3& point : mesh.points) values.insert(values.end(), point.data(), point.data() + 3);
  return array_of(std::move(values), 3);
}

/// For each block the type, its number in VTK, and the nodes of the cells in the order of VTK.
py::list cells_of(const io::FieldMesh& mesh) {
  py::list blocks;
  for (const mesh::CellBlock& block : mesh.blocks) {
    const std::span<const int> order = io::vtk_order(block.type);
    std::vector<std::int64_t> nodes;
    nodes.reserve(block.connectivity.size());
    for (std::size_t c = 0; c < block.size(); ++c)
      for (const int i : order) nodes.push_back(block.cell(c)[static_cast<std::size_t>(i)]);
    blocks.append(py::make_tuple(std::string(mesh::name(block.type)), io::vtk_cell_type(block.type),
                                 array_of(std::move(nodes), static_cast<py::ssize_t>(order.size()))));
  }
  return blocks;
}

py::dict texts_of(const io::FieldMesh& mesh) {
  py::dict texts;
  for (const io::TextArray& text : mesh.texts) texts[py::str(text.name)] = text.values;
  return texts;
}

}  // namespace

void bind_fields(py::module_& module) {
  py::class_<io::FieldMesh>(module, "FieldMesh")
      .def_property_readonly("points", points_of)
      .def_property_readonly("cells", cells_of)
      .def_property_readonly("texts", texts_of);
  module.def("csv_table", [](const std::filesystem::path& path) {
    io::CsvTable table = io::read_csv_table(path, io::UnendedRow::is_left_out);
    py::dict columns;
    for (std::size_t i = 0; i < table.names.size(); ++i)
      columns[py::str(table.names[i])] = array_of(std::move(table.columns[i]));
    return columns;
  });
  module.def("field_list", [](const std::filesystem::path& list) {
    py::list all;
    for (const io::FieldEntry& entry : io::read_field_list(list)) all.append(py::make_tuple(entry.time, entry.file));
    return all;
  });
  py::class_<io::FieldFile>(module, "FieldFile")
      .def(py::init<const std::filesystem::path&>())
      .def("mesh", &io::FieldFile::mesh)
      .def("names",
           [](const io::FieldFile& file) {
             std::vector<std::string> names;
             for (const io::FieldArray& array : file.point_arrays()) names.push_back(array.name);
             return names;
           })
      .def("values", [](const io::FieldFile& file, const std::string& name) {
        py::ssize_t components = 1;
        for (const io::FieldArray& array : file.point_arrays())
          if (array.name == name) components = array.components;
        return array_of(file.point_values(name), components);
      });
}

}  // namespace creepcontact::python
