#include "hourglass.hpp"

#include <algorithm>

#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/dense.hpp"

namespace creepcontact::mechanics {
namespace {

constexpr double stiffness_fraction = 1e-6;
/// Projector onto the part of nodal values that no quadratic polynomial of the place represents.
Eigen::MatrixXd non_quadratic_projector(const mesh::Mesh& mesh, std::span<const std::int64_t> cell) {
  const Index n_nodes = std::ssize(cell);
  Vector3 centre = Vector3::Zero();
  for (const std::int64_t node : cell) centre += mesh.nodes[node] / static_cast<double>(n_nodes);
  double size = 0;
  for (const std::int64_t node : cell) size = std::max(size, (mesh.nodes[node] - centre).norm());
  Eigen::MatrixXd polynomials(n_nodes, 10);
  for (Index i = 0; i < n_nodes; ++i) {
    const Vector3 r = (mesh.nodes[cell[i]] - centre) / size;
    polynomials.row(i) << 1, r.x(), r.y(), r.x() * r.x(), r.y() * r.y(), r.x() * r.y(), r.z(), r.z() * r.z(),
        r.y() * r.z(), r.z() * r.x();
  }
  if (mesh.section.dimension() == 2) polynomials.conservativeResize(Eigen::NoChange, 6);
  const Eigen::MatrixXd basis = linalg::orthonormal_basis(polynomials);
  return Eigen::MatrixXd::Identity(n_nodes, n_nodes) - basis * basis.transpose();
}

}  // namespace

bool has_hourglass_modes(mesh::CellType type) {
  return type == mesh::CellType::hex20 || type == mesh::CellType::quad8;
}

void add_hourglass_stiffness(const mesh::Mesh& mesh, const Eigen::VectorXd& diagonal, linalg::SparseMatrix& lower) {
  for (const mesh::CellBlock& block : mesh.blocks) {
    if (!mesh.is_bulk(block.type) || !has_hourglass_modes(block.type)) continue;
    const auto n_nodes = static_cast<double>(mesh::n_nodes(block.type));
    for (std::size_t c = 0; c < block.size(); ++c) {
      const auto cell = block.cell(c);
      double own = 0;
      for (const std::int64_t node : cell) own += diagonal.segment<3>(3 * node).sum() / (3 * n_nodes);
      const Eigen::MatrixXd matrix = stiffness_fraction * own * non_quadratic_projector(mesh, cell);
      for (Index a = 0; a < matrix.rows(); ++a)
        for (Index b = 0; b < matrix.cols(); ++b) {
          const std::int64_t row = cell[a], column = cell[b];
          for (int k = 0; k < 3 && row >= column; ++k) lower.coeffRef(3 * row + k, 3 * column + k) += matrix(a, b);
        }
    }
  }
}

}  // namespace creepcontact::mechanics
