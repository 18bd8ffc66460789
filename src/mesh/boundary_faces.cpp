#include <fmt/format.h>

#include <unordered_map>
#include <unordered_set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/mesh/cell_faces.hpp"
#include "creepcontact/mesh/group_kind.hpp"
#include "creepcontact/mesh/mesh.hpp"
#include "face_key.hpp"

namespace creepcontact::mesh {
namespace {

std::string position(const Mesh& mesh, std::span<const std::int64_t> nodes) {
  Vector3 centre = Vector3::Zero();
  for (std::int64_t node : nodes) centre += mesh.nodes[node];
  centre /= static_cast<double>(nodes.size());
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", centre[0], centre[1], centre[2]);
}

Face global_face(const LocalFace& local, std::span<const std::int64_t> cell) {
  Face face{local.type, {}};
  face.nodes.reserve(local.nodes.size());
  for (int node : local.nodes) face.nodes.push_back(cell[node]);
  return face;
}

}  // namespace

std::vector<Face> boundary_faces(const Mesh& mesh, const std::string& surface) {
  const Group& group = mesh.group(surface, mesh.section.dimension() - 1);
  std::unordered_map<FaceKey, std::size_t, FaceKeyHash> index;  // position of the surface cell in the result
  index.reserve(group.cells.size());
  std::vector<CellRef> wanted;
  for (const CellRef& ref : group.cells) {
    const CellBlock& block = mesh.blocks[ref.block];
    if (index.emplace(face_key(block.type, block.cell(ref.cell)), wanted.size()).second) wanted.push_back(ref);
  }

  std::vector<Face> faces(wanted.size());
  for (const CellBlock& block : mesh.blocks) {
    if (!mesh.is_bulk(block.type)) continue;
    const auto& locals = cell_faces(block.type);
    for (std::size_t c = 0; c < block.size(); ++c) {
      const auto cell = block.cell(c);
      for (const LocalFace& local : locals) {
        const auto found = index.find(face_key(local.type, [&](int i) { return cell[local.nodes[i]]; }));
        if (found == index.end()) continue;
        Face& face = faces[found->second];
        if (!face.nodes.empty()) {
          throw ModelError(
              fmt::format("{} '{}' lies inside the body, between two of its cells, at {}; it has to be on the boundary",
                          group_kind(group.dimension), surface, position(mesh, face.nodes)));
        }
        face = global_face(local, cell);
      }
    }
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!faces[i].nodes.empty()) continue;
    const CellBlock& block = mesh.blocks[wanted[i].block];
    const auto cell = block.cell(wanted[i].cell);
    throw ModelError(fmt::format("{} '{}': the {} at {} is not {} cell", group_kind(group.dimension), surface,
                                 name(block.type), position(mesh, cell),
                                 mesh.section.dimension() == 3 ? "a face of any volume" : "an edge of any surface"));
  }
  return faces;
}

std::size_t n_orphan_faces(const Mesh& mesh, const std::string& surface) {
  std::unordered_set<FaceKey, FaceKeyHash> orphans;
  for (const CellRef& ref : mesh.group(surface, mesh.section.dimension() - 1).cells) {
    const CellBlock& block = mesh.blocks[ref.block];
    orphans.insert(face_key(block.type, block.cell(ref.cell)));
  }
  for (const CellBlock& block : mesh.blocks)
    for (std::size_t c = 0; c < block.size() && mesh.is_bulk(block.type) && !orphans.empty(); ++c)
      for (const LocalFace& local : cell_faces(block.type))
        orphans.erase(face_key(local.type, [&](int i) { return block.cell(c)[local.nodes[i]]; }));
  return orphans.size();
}

}  // namespace creepcontact::mesh
