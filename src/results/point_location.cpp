#include "point_location.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

#include "creepcontact/fem/tangents.hpp"

namespace creepcontact::results {
namespace {

constexpr double max_extrapolation = 0.1;  // of an element's size, for points outside the mesh

/// Nearest place of the reference domain.
Vector3 clamp(const Vector3& xi, mesh::CellType type) {
  const auto into_simplex = [](Vector3 p, int dimension) {
    for (int i = 0; i < dimension; ++i) p[i] = std::max(p[i], 0.0);
    const double sum = p.head(dimension).sum();
    if (sum > 1) p.head(dimension) /= sum;
    return p;
  };
  if (mesh::n_corners(type) == 3) return into_simplex(xi, 2);
  if (mesh::n_corners(type) == 4 && mesh::dimension(type) == 3) return into_simplex(xi, 3);
  if (mesh::n_corners(type) == 6) {
    Vector3 p = into_simplex(xi, 2);
    p[2] = std::clamp(p[2], -1.0, 1.0);
    return p;
  }
  return xi.cwiseMax(-1.0).cwiseMin(1.0);
}

Eigen::AlignedBox3d box_of(const mesh::Mesh& mesh, std::span<const std::int64_t> nodes) {
  Eigen::AlignedBox3d box;
  for (const std::int64_t node : nodes) box.extend(mesh.nodes[node]);
  return box;
}

std::vector<Eigen::AlignedBox3d> boxes_in_reach(const mesh::Mesh& mesh) {
  constexpr double rounding = 1.01;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const mesh::CellBlock& block : mesh.blocks) {
    if (!mesh.is_bulk(block.type)) continue;
    for (std::size_t cell = 0; cell < block.size(); ++cell) {
      const Eigen::AlignedBox3d box = box_of(mesh, block.cell(cell));
      const Vector3 margin = Vector3::Constant(rounding * max_extrapolation * box.diagonal().norm());
      boxes.emplace_back(box.min() - margin, box.max() + margin);
    }
  }
  return boxes;
}

/// Newton iteration for x(xi) = at, held inside the element.
std::optional<PointLocation> locate_in(const mesh::Mesh& mesh, const mesh::CellBlock& block, std::size_t cell,
                                       const Vector3& at) {
  const fem::ReferenceElement& element = fem::reference_element(block.type);
  const auto nodes = block.cell(cell);
  const Eigen::AlignedBox3d box = box_of(mesh, nodes);
  const double size = box.diagonal().norm();
  if (box.exteriorDistance(at) > max_extrapolation * size) return std::nullopt;

  const int n = element.n_nodes();
  Eigen::VectorXd shape(n);
  Eigen::MatrixX3d gradient(n, 3);
  Eigen::Matrix3Xd x(3, n);
  for (int i = 0; i < n; ++i) x.col(i) = mesh.nodes[nodes[i]];
  Vector3 xi = element.nodes().colwise().mean().transpose();
  for (int iteration = 0; iteration < 30; ++iteration) {
    element.shape(xi, shape);
    element.gradient(xi, gradient);
    const Vector3 residual = at - x * shape;
    const Vector3 next = clamp(xi + fem::jacobian(element, x, gradient).inverse() * residual, block.type);
    const bool done = (next - xi).norm() < 1e-13;
    xi = next;
    if (done) break;
  }
  element.shape(xi, shape);
  PointLocation result;
  result.nodes.assign(nodes.begin(), nodes.end());
  result.weights.assign(shape.begin(), shape.end());
  result.position = at;
  result.distance = (at - x * shape).norm();
  if (result.distance > max_extrapolation * size) return std::nullopt;
  return result;
}

}  // namespace

PointLocator::PointLocator(const mesh::Mesh& mesh) : mesh_(mesh), cells_(boxes_in_reach(mesh)) {}

std::optional<PointLocation> PointLocator::locate(const Vector3& at) const {
  const std::vector<std::size_t> near = cells_.meeting({at, at});
  std::optional<PointLocation> best;
  std::size_t first = 0;  // element of the block
  auto element = near.begin();
  for (const mesh::CellBlock& block : mesh_.blocks) {
    if (!mesh_.is_bulk(block.type)) continue;
    for (; element != near.end() && *element < first + block.size(); ++element) {
      auto found = locate_in(mesh_, block, *element - first, at);
      if (!found || (best && found->distance >= best->distance)) continue;
      found->element = *element;
      best = std::move(found);
    }
    first += block.size();
  }
  return best;
}

}  // namespace creepcontact::results
