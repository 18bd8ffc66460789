#include "creepcontact/mesh/shared_nodes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <unordered_map>

#include "creepcontact/mesh/cell_faces.hpp"
#include "face_key.hpp"

namespace creepcontact::mesh {
namespace {

/// Area by a triangle fan, which is accurate enough for warped faces; for an edge its length.
double polygon_area(const Mesh& mesh, const Face& face) {
  const auto at = [&](int i) { return mesh.nodes[face.nodes[i]]; };
  if (n_corners(face.type) == 2) return (at(1) - at(0)).norm();
  Vector3 area = Vector3::Zero();
  for (int i = 1; i + 1 < n_corners(face.type); ++i) area += 0.5 * (at(i) - at(0)).cross(at(i + 1) - at(0));
  return area.norm();
}

/// Calls visit(face) for every face of a body's cells whose nodes are all shared.
template <class Visit>
void for_each_shared_face(const Mesh& mesh, const std::vector<std::int64_t>& index, Visit visit) {
  Face face;
  for (const CellBlock& block : mesh.blocks)
    for (std::size_t c = 0; c < block.size() && mesh.is_bulk(block.type); ++c)
      for (const LocalFace& local : cell_faces(block.type)) {
        face.type = local.type;
        face.nodes.clear();
        for (const int node : local.nodes) face.nodes.push_back(block.cell(c)[node]);
        if (std::all_of(face.nodes.begin(), face.nodes.end(), [&](std::int64_t node) { return index[node] >= 0; }))
          visit(face);
      }
}

}  // namespace

SharedMesh shared_mesh(std::span<const BodyMesh> bodies) {
  std::map<std::int64_t, SharedNode> by_parent;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (std::size_t i = 0; i < bodies[b].parent_node.size(); ++i)
      by_parent[bodies[b].parent_node[i]].owners.push_back({b, static_cast<std::int64_t>(i)});

  SharedMesh shared;
  std::vector<std::vector<std::int64_t>> index;  // of the bodies' nodes in shared.nodes, -1: not shared
  for (const BodyMesh& body : bodies) index.emplace_back(body.mesh.nodes.size(), -1);
  for (auto& [parent, node] : by_parent) {
    if (node.owners.size() < 2) continue;
    for (const SharedNode::Owner& owner : node.owners)
      index[owner.body][owner.node] = static_cast<std::int64_t>(shared.nodes.size());
    shared.nodes.push_back(std::move(node));
  }
  if (shared.nodes.empty()) return shared;

  std::unordered_map<FaceKey, std::size_t, FaceKeyHash> owner;  // the body that a face was met in first
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for_each_shared_face(bodies[b].mesh, index[b], [&](const Face& face) {
      const auto shared_index = [&](int i) { return index[b][face.nodes[i]]; };
      const auto [found, is_new] = owner.emplace(face_key(face.type, shared_index), b);
      if (is_new || found->second == b) return;
      SharedFace& made =
          shared.faces.emplace_back(SharedFace{found->second, b, {}, polygon_area(bodies[b].mesh, face)});
      for (int i = 0; i < std::ssize(face.nodes); ++i) made.nodes.push_back(shared_index(i));
    });
  return shared;
}

}  // namespace creepcontact::mesh
