#include "creepcontact/mechanics/constraints.hpp"

namespace creepcontact::mechanics {

namespace {

/// The 3 x 3 blocks of one block column, from the diagonal downwards, of a lower triangle in whole node blocks.
class BlockColumn {
 public:
  BlockColumn(const linalg::SparseMatrix& lower, std::int64_t node) : lower_(lower), node_(node) {}

  std::int64_t size() const { return (start(1) - start(0)) / 3; }
  std::int64_t row_node(std::int64_t i) const { return lower_.innerIndexPtr()[start(0) + 3 * i] / 3; }
  Matrix3 block(std::int64_t i) const {
    Matrix3 block;
    for (int j = 0; j < 3; ++j) {
      const double* value = lower_.valuePtr() + start(j) + 3 * i - j;  // column j of the diagonal block begins at row j
      for (int k = i == 0 ? j : 0; k < 3; ++k) block(k, j) = value[k];
    }
    if (i == 0) block.triangularView<Eigen::StrictlyUpper>() = block.transpose();
    return block;
  }

 private:
  std::int64_t start(int column) const { return lower_.outerIndexPtr()[3 * node_ + column]; }
  const linalg::SparseMatrix& lower_;
  std::int64_t node_;
};

}  // namespace

linalg::SparseMatrix Constraints::reduce(const linalg::SparseMatrix& lower) const {
  if (!links_.empty()) return reduce_linked(lower);
  const std::int64_t n_nodes = frame_of_node_.size();
  linalg::SparseMatrix reduced(n_free(), n_free());
  std::int64_t* column_start = reduced.outerIndexPtr();
  for (std::int64_t b = 0; b < n_nodes; ++b) {
    const BlockColumn column(lower, b);
    std::int64_t rows = 0;
    for (std::int64_t i = 0; i < column.size(); ++i) rows += 3 - n_held(column.row_node(i));
    for (int j = n_held(b); j < 3; ++j, --rows) {
      const std::int64_t free = free_index(b)[j];
      column_start[free + 1] = column_start[free] + std::max<std::int64_t>(0, rows);  // none at a node without elements
    }
  }
  reduced.resizeNonZeros(column_start[n_free()]);

#pragma omp parallel for schedule(static)
  for (std::int64_t b = 0; b < n_nodes; ++b) {
    const int held_b = n_held(b);
    if (held_b == 3) continue;
    const BlockColumn column(lower, b);
    const Frame* frame_b = frame_or_null(b);
    std::array<std::int64_t, 3> next{};
    for (std::size_t j = held_b; j < 3; ++j) next[j] = column_start[free_index(b)[j]];
    for (std::int64_t i = 0; i < column.size(); ++i) {
      const std::int64_t a = column.row_node(i);
      const Frame* frame_a = frame_or_null(a);
      Matrix3 block = column.block(i);
      if (frame_a) block = (frame_a->axes.transpose() * block).eval();
      if (frame_b) block = (block * frame_b->axes).eval();
      for (int j = held_b; j < 3; ++j) {
        std::int64_t& position = next[j];
        for (int k = a == b ? j : n_held(a); k < 3; ++k, ++position) {
          reduced.innerIndexPtr()[position] = free_index(a)[k];
          reduced.valuePtr()[position] = block(k, j);
        }
      }
    }
  }
  return reduced;
}

void Constraints::add_to(Checksum& sum) const {
  sum.add(frame_of_node_.data(), frame_of_node_.size());
  for (const Frame& frame : frames_) {
    sum.add(frame.axes.data(), 9);
    sum.add(&frame.n_held, 1);
  }
  for (const auto& free : free_index_) sum.add(free.data(), free.size());
  if (links_.empty()) return;
  sum.add(transformation_.outerIndexPtr(), static_cast<std::size_t>(transformation_.outerSize() + 1));
  sum.add(transformation_.innerIndexPtr(), static_cast<std::size_t>(transformation_.nonZeros()));
  sum.add(transformation_.valuePtr(), static_cast<std::size_t>(transformation_.nonZeros()));
}

Eigen::SparseMatrix<double, Eigen::RowMajor> Constraints::reduce_rows(
    const Eigen::SparseMatrix<double, Eigen::RowMajor>& rows) const {
  using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  if (!links_.empty()) {
    const linalg::SparseMatrix product = linalg::SparseMatrix(rows) * transformation_;
    return Rows(product);
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < rows.outerSize(); ++i) {
    for (Rows::InnerIterator it(rows, i); it; ++it) {
      const std::int64_t node = it.col() / 3;
      const Matrix3 axes = frame(node);
      for (int k = n_held(node); k < 3; ++k) {
        const double value = it.value() * axes(it.col() % 3, k);
        if (value != 0) entries.emplace_back(i, static_cast<int>(free_index(node)[k]), value);
      }
    }
  }
  Rows reduced(rows.rows(), n_free());
  reduced.setFromTriplets(entries.begin(), entries.end());
  return reduced;
}

}  // namespace creepcontact::mechanics
