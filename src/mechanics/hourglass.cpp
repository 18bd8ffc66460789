#include "hourglass.hpp"

#include <algorithm>

#include "creepcontact/linalg/dense.hpp"

namespace creepcontact::mechanics {
namespace {

constexpr double fraction = 1e-6;
constexpr int n_nodes = 20;
using Square = Eigen::Matrix<double, n_nodes, n_nodes>;

/// Projector on what remains of nodal values beside quadratic polynomials of the place.
Square beside_quadratics(const mesh::Mesh& mesh, std::span<const std::int64_t> cell) {
  Vector3 centre = Vector3::Zero();
  for (const std::int64_t node : cell) centre += mesh.nodes[node] / n_nodes;
  double size = 0;
  for (const std::int64_t node : cell) size = std::max(size, (mesh.nodes[node] - centre).norm());
  Eigen::Matrix<double, n_nodes, 10> polynomials;
  for (int i = 0; i < n_nodes; ++i) {
    const Vector3 r = (mesh.nodes[cell[i]] - centre) / size;
    polynomials.row(i) << 1, r.x(), r.y(), r.z(), r.x() * r.x(), r.y() * r.y(), r.z() * r.z(), r.x() * r.y(),
        r.y() * r.z(), r.z() * r.x();
  }
  const Eigen::MatrixXd basis = linalg::orthonormal_basis(polynomials);
  return Square::Identity() - basis * basis.transpose();
}

}  // namespace

void add_hourglass_stiffness(const mesh::Mesh& mesh, const Eigen::VectorXd& diagonal, linalg::SparseMatrix& lower) {
  for (const mesh::CellBlock& block : mesh.blocks) {
    if (block.type != mesh::CellType::hex20) continue;
    for (std::size_t c = 0; c < block.size(); ++c) {
      const auto cell = block.cell(c);
      double own = 0;
      for (const std::int64_t node : cell) own += diagonal.segment<3>(3 * node).sum() / (3 * n_nodes);
      const Square matrix = fraction * own * beside_quadratics(mesh, cell);
      for (int a = 0; a < n_nodes; ++a)
        for (int b = 0; b < n_nodes; ++b) {
          const std::int64_t row = cell[a], column = cell[b];
          for (int k = 0; k < 3 && row >= column; ++k) lower.coeffRef(3 * row + k, 3 * column + k) += matrix(a, b);
        }
    }
  }
}

}  // namespace creepcontact::mechanics
