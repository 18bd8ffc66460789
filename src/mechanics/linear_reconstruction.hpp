#pragma once
/// Gradients of element means: the least-squares fit, weighted by volume, to the means of all elements that share a
/// corner. Where an element's own points vary in ways of no meaning (stress in linear elements, mean stress in
/// tetrahedra of bad shape), the means are an order more accurate. Source: Barth and Jespersen (1989), reconstruction
/// in finite volumes.

#include <functional>
#include <span>
#include <vector>

#include "element_block.hpp"
#include "node_entries.hpp"

namespace creepcontact::mechanics {

/// Immutable. Elements are those of the body, one block after the other.
class LinearReconstruction {
 public:
  using Blocks = std::vector<std::shared_ptr<const ElementBlock>>;
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// True of the elements whose gradients are reconstructed: linear ones, and tet10 (its mean stress).
  static bool serves(mesh::CellType type) { return mesh::order(type) == 1 || type == mesh::CellType::tet10; }

  /// @param point_coordinates, weights  of all points of the body @param element_of  element of an entry of `entries`
  LinearReconstruction(const Blocks& blocks, const NodeEntries& entries, std::span<const Vector3> point_coordinates,
                       std::span<const double> weights, const std::function<std::size_t(std::size_t)>& element_of);

  const Vector3& centre(std::size_t element) const { return centres_[element]; }
  /// 3 x width, by columns of `means`. Precondition: serves the element's type
  /// @param means  n_elements x width @param own  values at the element's own points, n_points x width: they count
  /// where neighbours tell nothing, across a single layer of elements
  Rows gradient(const ElementBlock& block, std::size_t e, std::span<const double> means,
                const Eigen::Ref<const Rows>& own) const;

 private:
  std::vector<Vector3> centres_, positions_;
  std::vector<double> volumes_;
  std::vector<std::size_t> offsets_;  // of the neighbours of an element
  std::vector<std::uint32_t> neighbours_;
  std::vector<Matrix3> inverse_;  // of the normal matrix
};

}  // namespace creepcontact::mechanics
