/// Temperatures in .vtu files, and the fields of a run.

#include "../../src/io/temperatures/vtu_temperatures.hpp"
#include "creepcontact/io/fields/field_reader.hpp"
#include "fuzz_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace creepcontact;
  fuzz::may_refuse([&] {
    const io::PointTemperatures read = io::parse_vtu(fuzz::text_of(data, size), "fuzz.vtu", "");
    fuzz::require(!read.points.empty(), "what is accepted has points");
    fuzz::require(read.values.size() == 1 && read.values[0].size() == read.points.size(), "a value at every point");
  });
  fuzz::may_refuse([&] {
    const io::FieldFile file(std::string(fuzz::text_of(data, size)), "fuzz.vtu");
    const io::FieldMesh mesh = file.mesh();
    fuzz::require(mesh.points.size() == file.n_points() && mesh.n_cells() == file.n_cells(), "the mesh is whole");
    for (const io::FieldArray& array : file.point_arrays()) fuzz::may_refuse([&] { file.point_values(array.name); });
  });
  return 0;
}
