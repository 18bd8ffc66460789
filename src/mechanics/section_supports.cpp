#include "section_supports.hpp"

#include <numeric>

#include "creepcontact/mesh/axis.hpp"

namespace creepcontact::mechanics {

std::vector<Support> with_section_supports(const mesh::Mesh& mesh, const std::vector<Support>& supports) {
  if (mesh.section.dimension() == 3) return supports;
  std::vector<std::int64_t> all(mesh.n_cell_nodes());
  std::iota(all.begin(), all.end(), std::int64_t{0});
  std::vector<Support> result{{.on = "plane z = 0", .nodes = all, .directions = {Vector3::UnitZ()}, .value = 0.0}};
  if (mesh.section.is_axisymmetric())
    result.push_back(
        {.on = "axis x = 0", .nodes = mesh::axis_nodes(mesh), .directions = {Vector3::UnitX()}, .value = 0.0});
  if (mesh.axial_node >= 0)
    for (const Vector3& direction : {Vector3(Vector3::UnitX()), Vector3(Vector3::UnitY())})
      result.push_back({.on = "axial strain", .nodes = {mesh.axial_node}, .directions = {direction}, .value = 0.0});
  result.insert(result.end(), supports.begin(), supports.end());
  return result;
}

}  // namespace creepcontact::mechanics
