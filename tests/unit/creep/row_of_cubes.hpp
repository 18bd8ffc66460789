#pragma once
/// A body of pieces that meet nowhere, so that processes can hold and solve the pieces each alone.

#include <string>
#include <vector>

#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/material/registry.hpp"
#include "creepcontact/mesh/cell_faces.hpp"

namespace creepcontact::test {

/// Cubes first .. first + count - 1 of a row, 10 apart.
inline mesh::Mesh cubes(int first, int count) {
  mesh::Mesh mesh;
  mesh.blocks = {{mesh::CellType::hex8, {}}, {mesh::CellType::quad4, {}}};
  for (const char* name : {"x0", "x1", "y0", "z0"}) mesh.groups[name] = {name, 2, {}};
  for (int i = 0; i < count; ++i) {
    const auto node = std::ssize(mesh.nodes);
    for (const double z : {0.0, 1.0})
      for (const auto& [x, y] : {std::pair(0.0, 0.0), {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
        mesh.nodes.emplace_back(10 * (first + i) + x, y, z);
    for (std::int64_t k = 0; k < 8; ++k) mesh.blocks[0].connectivity.push_back(node + k);
    const std::size_t face = mesh.blocks[1].size();
    for (const int k : {0, 4, 7, 3, 1, 2, 6, 5, 0, 1, 5, 4, 0, 3, 2, 1})
      mesh.blocks[1].connectivity.push_back(node + k);
    std::size_t side = 0;
    for (const char* name : {"x0", "x1", "y0", "z0"}) mesh.groups[name].cells.push_back({1, face + side++});
  }
  return mesh;
}

inline material::Material damaging_material() {
  material::Material material;
  material.name = "steel";
  material.young_modulus = Function::expression("2e5-60*T", {"T"});
  material.poisson_ratio = 0.3;
  material.thermal_expansion = 1e-5;
  material.creep.push_back(
      material::find_creep_law("kachanov_rabotnov")
          ->make_by_key({{"A", {1e-12}}, {"n", {3.0}}, {"B", {1e-7}}, {"r", {1.0}}, {"phi", {3.0}}}));
  return material;
}

/// Held by the face x0 as a whole (so that the stress is uneven), pulled more the smaller x is; heated in time.
inline creep::Assembly row_of_cubes(const Team& team, int first, int count) {
  const mesh::Mesh mesh = cubes(first, count);
  std::vector<mechanics::Support> supports;
  for (int axis = 0; axis < 3; ++axis)
    supports.push_back({"x0", mesh::group_nodes(mesh, "x0"), {Vector3(Vector3::Unit(axis))}, 0.0});
  std::vector<mechanics::Body> bodies;
  bodies.emplace_back("bar", mesh, damaging_material(), supports,
                      mechanics::TemperatureField(Function::expression("t*(1+0.05*x)", {"x", "t"})));
  bodies[0].add_load(mechanics::traction_load(mesh, mesh::boundary_faces(mesh, "x1"),
                                              {Function::expression("100-x", {"x"}), 0.0, 0.0}));
  return {std::move(bodies), {}, {}, team};
}

}  // namespace creepcontact::test
