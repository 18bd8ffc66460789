#include "creepcontact/contact/geometry/contact_grid.hpp"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "creepcontact/contact/geometry/facet.hpp"

namespace creepcontact::contact {
namespace {

/// Rows of the multiplier nodes at each mesh node: one, or several at a crease.
std::unordered_map<std::int64_t, std::vector<int>> rows_of_nodes(const std::vector<contact::MultiplierNode>& nodes) {
  std::unordered_map<std::int64_t, std::vector<int>> rows;
  for (std::size_t i = 0; i < nodes.size(); ++i) rows[nodes[i].node].push_back(static_cast<int>(i));
  return rows;
}

}  // namespace

ContactGrid::ContactGrid(const contact::Pair& pair, const mesh::Mesh& slave) {
  const std::vector<contact::MultiplierNode>& nodes = pair.coupling.nodes;
  for (const contact::MultiplierNode& node : nodes) positions.push_back(slave.nodes[node.node]);
  const auto rows = rows_of_nodes(nodes);
  std::vector<std::set<int>> found_around(positions.size());
  const std::vector<mesh::Face> faces = mesh::boundary_faces(slave, pair.slave_surface);
  for (const contact::Facet& face : contact::make_facets(slave, faces)) {
    Facet facet;
    const Vector3 normal = face.area_vector_at_centre();
    for (int corner = 0; corner < face.n_corners(); ++corner) {
      const auto found = rows.find(face.nodes()[corner]);
      if (found == rows.end()) break;
      const auto less = [&](int a, int b) { return nodes[a].normal.dot(normal) < nodes[b].normal.dot(normal); };
      facet.positions[facet.n_corners] = face.node_position(corner);
      facet.rows[facet.n_corners++] = *std::max_element(found->second.begin(), found->second.end(), less);
    }
    if (facet.n_corners < static_cast<std::size_t>(face.n_corners())) continue;
    for (std::size_t i = 0; i < facet.n_corners; ++i)
      for (std::size_t j = 0; j < facet.n_corners; ++j)
        if (facet.rows[i] != facet.rows[j]) found_around[facet.rows[i]].insert(facet.rows[j]);
    facets.push_back(facet);
  }
  for (const std::set<int>& found : found_around) neighbours.emplace_back(found.begin(), found.end());
}

}  // namespace creepcontact::contact
