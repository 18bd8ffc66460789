#include "creepcontact/contact/geometry/contact_grid.hpp"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "creepcontact/contact/geometry/facet.hpp"

namespace creepcontact::contact {
namespace {

/// A multiplier at a node of the mesh, or the image of one.
struct RowAtNode {
  int own = 0;
  int turns = 0;
  Vector3 normal;
};

/// The rows at each node of the mesh: one, or several at a crease.
std::unordered_map<std::int64_t, std::vector<RowAtNode>> rows_of_nodes(const contact::MortarCoupling& coupling) {
  std::unordered_map<std::int64_t, std::vector<RowAtNode>> rows;
  for (std::size_t i = 0; i < coupling.nodes.size(); ++i)
    rows[coupling.nodes[i].node].push_back({static_cast<int>(i), 0, coupling.nodes[i].normal});
  for (const contact::MortarCoupling::Image& image : coupling.images)
    rows[image.at.node].push_back({static_cast<int>(image.of), 1, image.at.normal});
  return rows;
}

}  // namespace

ContactGrid::ContactGrid(const contact::Pair& pair, const mesh::Mesh& slave)
    : n_own(static_cast<int>(pair.coupling.nodes.size())), sector(pair.coupling.sector) {
  const std::vector<contact::MultiplierNode>& nodes = pair.coupling.nodes;
  std::vector<int> sectors{0};
  if (sector)
    for (const int turns : sector->neighbours()) sectors.push_back(turns);
  for (const int turns : sectors)
    for (const contact::MultiplierNode& node : nodes)
      positions.push_back(turns == 0 ? slave.nodes[node.node] : sector->turned(slave.nodes[node.node], turns));
  /// -1 beyond the sectors that are here.
  const auto row = [&](int own, int turns) {
    const auto found = std::ranges::find(sectors, sector ? turns % sector->count : turns);
    return found == sectors.end() ? -1 : own + n_own * static_cast<int>(found - sectors.begin());
  };

  const auto rows = rows_of_nodes(pair.coupling);
  std::vector<std::set<int>> found_around(positions.size());
  const std::vector<mesh::Face> faces = mesh::boundary_faces(slave, pair.slave_surface);
  for (const contact::Facet& face : contact::make_facets(slave, faces)) {
    std::vector<RowAtNode> corners;
    Facet facet;
    const Vector3 normal = face.area_vector_at_centre();
    for (int corner = 0; corner < face.n_corners(); ++corner) {
      const auto found = rows.find(face.nodes()[corner]);
      if (found == rows.end()) break;
      corners.push_back(
          *std::ranges::max_element(found->second, {}, [&](const RowAtNode& at) { return at.normal.dot(normal); }));
      facet.positions[facet.n_corners] = face.node_position(corner);
      facet.rows[facet.n_corners++] = row(corners.back().own, corners.back().turns);
    }
    if (corners.size() < static_cast<std::size_t>(face.n_corners())) continue;
    for (const int turns : sectors)
      for (const RowAtNode& a : corners)
        for (const RowAtNode& b : corners) {
          const int first = row(a.own, turns + a.turns), second = row(b.own, turns + b.turns);
          if (first >= 0 && second >= 0 && first != second) found_around[first].insert(second);
        }
    facets.push_back(facet);
  }
  for (const std::set<int>& found : found_around) neighbours.emplace_back(found.begin(), found.end());
}

Eigen::VectorXd ContactGrid::of_all(const Eigen::VectorXd& of_own) const {
  return of_own.replicate(std::ssize(positions) / std::max(n_own, 1), 1);
}

Vector3 ContactGrid::image_near(int row, const Vector3& point) const {
  Vector3 nearest = point;
  if (!sector) return nearest;
  for (const int turns : sector->neighbours())
    if (const Vector3 image = sector->turned(point, turns);
        (image - positions[row]).squaredNorm() < (nearest - positions[row]).squaredNorm())
      nearest = image;
  return nearest;
}

}  // namespace creepcontact::contact
