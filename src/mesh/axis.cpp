#include "creepcontact/mesh/axis.hpp"

#include <algorithm>
#include <cmath>

namespace creepcontact::mesh {
namespace {

constexpr double on_axis = 1e-9;  // of the largest radius

}  // namespace

std::vector<std::int64_t> axis_nodes(const Mesh& mesh) {
  double largest = 0;
  for (const Vector3& x : mesh.nodes) largest = std::max(largest, x.x());
  std::vector<std::int64_t> nodes;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    if (std::abs(mesh.nodes[i].x()) <= on_axis * largest) nodes.push_back(static_cast<std::int64_t>(i));
  return nodes;
}

}  // namespace creepcontact::mesh
