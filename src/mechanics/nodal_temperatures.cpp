#include "nodal_temperatures.hpp"

#include <algorithm>
#include <map>

#include "creepcontact/fem/reference_element.hpp"
#include "creepcontact/mesh/cell_faces.hpp"

namespace creepcontact::mechanics {
namespace {

enum class Role : char { none, mid_side, corner };

/// The role of each node in the bulk cells.
std::vector<Role> roles(const mesh::Mesh& mesh) {
  std::vector<Role> all(mesh.nodes.size(), Role::none);
  for (const mesh::CellBlock& block : mesh.blocks) {
    if (!mesh.is_bulk(block.type)) continue;
    const auto n_corners = static_cast<std::size_t>(mesh::n_corners(block.type));
    for (std::size_t c = 0; c < block.size(); ++c) {
      const auto cell = block.cell(c);
      for (std::size_t i = 0; i < cell.size(); ++i)
        all[cell[i]] = std::max(all[cell[i]], i < n_corners ? Role::corner : Role::mid_side);
    }
  }
  return all;
}

/// Gives the nodes on edges that have no point the mean of the ends; @returns false if others are left, which lie
/// within faces and cells.
bool fill_mid_sides(const mesh::Mesh& mesh, std::vector<PointWeights>& at_nodes) {
  bool complete = true;
  for (const mesh::CellBlock& block : mesh.blocks) {
    if (!mesh.is_bulk(block.type) || mesh::order(block.type) == 1) continue;
    const auto& edges = mesh::cell_edges(block.type);
    const auto n_corners = static_cast<std::size_t>(mesh::n_corners(block.type));
    for (std::size_t c = 0; c < block.size(); ++c) {
      const auto cell = block.cell(c);
      for (std::size_t e = 0; e < edges.size(); ++e) {
        PointWeights& own = at_nodes[cell[n_corners + e]];
        if (!own.empty()) continue;
        for (const auto end : {edges[e][0], edges[e][1]})
          for (const PointWeight& one : at_nodes[cell[end]]) own.push_back({one.point, 0.5 * one.weight});
      }
      for (std::size_t i = n_corners + edges.size(); i < cell.size(); ++i)
        complete = complete && !at_nodes[cell[i]].empty();
    }
  }
  return complete;
}

}  // namespace

NodesAmongPoints nodes_among_points(const mesh::PointTree& points, const mesh::Mesh& mesh, double tolerance) {
  const std::vector<Role> role = roles(mesh);
  NodesAmongPoints result;
  result.at_nodes.resize(mesh.nodes.size());
  NodeCover& cover = result.cover;
  for (std::size_t i = 0; i < role.size(); ++i) {
    if (role[i] == Role::none) continue;
    const std::vector<mesh::Neighbour> nearest = points.nearest(mesh.nodes[i], 1);
    const bool is_point = !nearest.empty() && nearest[0].distance <= tolerance;
    if (is_point) result.at_nodes[i] = {{nearest[0].point, 1.0}};
    ++(role[i] == Role::corner ? cover.corners : cover.mid_sides);
    if (is_point) ++(role[i] == Role::corner ? cover.corners_given : cover.mid_sides_given);
  }
  cover.is_nodal = cover.corners > 0 && cover.corners_given == cover.corners && fill_mid_sides(mesh, result.at_nodes);
  return result;
}

std::vector<PointWeights> by_shape_functions(const Discretization& discretization, const mesh::Section& section,
                                             std::span<const PointWeights> at_nodes) {
  std::vector<PointWeights> weights(discretization.n_points());
  for (std::size_t e = 0; e < discretization.n_elements(); ++e) {
    const fem::ReferenceElement& element = fem::reference_element(discretization.element_type(e));
    const std::span<const std::int64_t> nodes = discretization.element_nodes(e);
    const std::size_t first = discretization.first_point(e);
    const fem::QuadratureRule& rule = fem::bulk_rule(element.type(), section);
    Eigen::VectorXd shape(element.n_nodes());
    for (std::size_t p = first; p < discretization.first_point(e + 1); ++p) {
      element.shape(rule.points.row(static_cast<Eigen::Index>(p - first)).transpose(), shape);
      std::map<std::size_t, double> sums;  // mid-side nodes without points share those of the corners
      for (std::size_t i = 0; i < nodes.size(); ++i)
        for (const PointWeight& one : at_nodes[nodes[i]])
          sums[one.point] += shape[static_cast<Eigen::Index>(i)] * one.weight;
      for (const auto& [point, weight] : sums) weights[p].push_back({point, weight});
    }
  }
  return weights;
}

}  // namespace creepcontact::mechanics
