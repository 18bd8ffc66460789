/// Meshes in Gmsh's format .msh, and the parts that a model takes of them.

#include <string>
#include <vector>

#include "../../src/io/msh/msh_reader.hpp"
#include "fuzz_target.hpp"

namespace creepcontact {
namespace {

void check(const mesh::Mesh& mesh) {
  for (const Vector3& node : mesh.nodes) fuzz::require(node.allFinite(), "nodes have finite places");
  if (mesh.section.dimension() == 2)
    for (const Vector3& node : mesh.nodes) fuzz::require(node.z() == 0, "sections are flat");
  const std::int64_t n_nodes = mesh.nodes.size();
  for (const mesh::CellBlock& block : mesh.blocks)
    for (const std::int64_t node : block.connectivity)
      fuzz::require(node >= 0 && node < n_nodes, "cells have nodes of the mesh");
  for (const auto& [name, group] : mesh.groups)
    for (const mesh::CellRef& at : group.cells)
      fuzz::require(at.block < mesh.blocks.size() && at.cell < mesh.blocks[at.block].size(), "groups have cells");
}

void cut(const mesh::Mesh& mesh) {
  for (const auto& [region, group] : mesh.groups) {
    if (group.dimension != mesh.section.dimension()) continue;
    const mesh::BodyMesh body = mesh::extract(mesh, {region});
    check(body.mesh);
    for (const auto& part : body.mesh.groups) {
      mesh::group_nodes(body.mesh, part.first);
      if (part.second.dimension == mesh.section.dimension() - 1)
        fuzz::may_refuse([&] { mesh::boundary_faces(body.mesh, part.first); });
    }
  }
}

}  // namespace
}  // namespace creepcontact

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace creepcontact;
  using settings::Analysis;
  for (const Analysis analysis : {Analysis::solid, Analysis::axisymmetric, Analysis::generalized_plane_strain})
    fuzz::may_refuse([&] {
      const mesh::Mesh mesh = io::read_msh(fuzz::text_of(data, size), "fuzz.msh", {analysis});
      check(mesh);
      cut(mesh);
    });
  return 0;
}
