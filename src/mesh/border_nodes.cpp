#include <algorithm>
#include <map>

#include "creepcontact/mesh/cell_faces.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mesh {

std::set<std::int64_t> border_nodes(const std::vector<Face>& faces) {
  struct Edge {
    int faces = 0;
    std::vector<std::int64_t> nodes;
  };
  std::map<std::pair<std::int64_t, std::int64_t>, Edge> edges;  // by the corners; of a curve's cell twice the same
  const auto add = [&](std::int64_t a, std::int64_t b) -> Edge& {
    Edge& edge = edges[std::minmax({a, b})];
    ++edge.faces;
    edge.nodes = {a, b};
    return edge;
  };
  for (const Face& face : faces) {
    const std::size_t corners = n_corners(face.type);
    if (dimension(face.type) == 1) {
      for (std::size_t i = 0; i < corners; ++i) add(face.nodes[i], face.nodes[i]);
      continue;
    }
    const auto& locals = cell_edges(face.type);
    for (std::size_t e = 0; e < locals.size(); ++e) {
      Edge& edge = add(face.nodes[locals[e][0]], face.nodes[locals[e][1]]);
      if (face.nodes.size() > corners) edge.nodes.push_back(face.nodes[corners + e]);
    }
  }
  std::set<std::int64_t> border;
  for (const auto& [corners, edge] : edges)
    if (edge.faces == 1) border.insert(edge.nodes.begin(), edge.nodes.end());
  return border;
}

}  // namespace creepcontact::mesh
