#include "creepcontact/mechanics/mesh_quality.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "creepcontact/base/index.hpp"
#include "creepcontact/fem/tangents.hpp"

namespace creepcontact::mechanics {

std::vector<Vector3> folded_elements(const mesh::Mesh& mesh) {
  std::vector<Vector3> centres;
  for (const mesh::CellBlock& block : mesh.blocks) {
    if (!mesh.is_bulk(block.type) || mesh::order(block.type) < 2) continue;
    const fem::ReferenceElement& element = fem::reference_element(block.type);
    std::vector<Eigen::MatrixX3d> gradients(mesh::n_corners(block.type));
    for (std::size_t i = 0; i < gradients.size(); ++i) {
      gradients[i].resize(element.n_nodes(), 3);
      element.gradient(element.nodes().row(i).transpose(), gradients[i]);
    }
    Eigen::Matrix3Xd x(3, element.n_nodes());
    for (std::size_t c = 0; c < block.size(); ++c) {
      for (Index a = 0; a < x.cols(); ++a) x.col(a) = mesh.nodes[block.cell(c)[a]];
      if (std::any_of(gradients.begin(), gradients.end(),
                      [&](const auto& gradient) { return fem::jacobian(element, x, gradient).determinant() <= 0; }))
        centres.emplace_back(x.rowwise().mean());
    }
  }
  return centres;
}

}  // namespace creepcontact::mechanics
