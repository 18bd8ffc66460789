#include "creepcontact/linalg/dense_products.hpp"

#include <algorithm>

#include "panel_kernels.hpp"

namespace creepcontact::linalg {
namespace {

Panel panel_of(const Eigen::MatrixXd& matrix, Index row, Index column, Index n_rows, Index n_columns) {
  return {matrix.data() + column * matrix.rows() + row, matrix.rows(), n_rows, n_columns};
}

Panel panel_of(const Eigen::MatrixXd& matrix) {
  return panel_of(matrix, 0, 0, matrix.rows(), matrix.cols());
}

}  // namespace

void add_product(const Eigen::MatrixXd& matrix, const ConstVectorRef& x, VectorRef into) {
  const Eigen::VectorXd subtracted = -x;
  subtract_product(panel_of(matrix), subtracted.data(), into.data());
}

Eigen::VectorXd transposed_product(const Eigen::MatrixXd& matrix, const ConstVectorRef& x) {
  const Eigen::VectorXd subtracted = -x;
  Eigen::VectorXd product = Eigen::VectorXd::Zero(matrix.cols());
  subtract_transposed_product(panel_of(matrix), subtracted.data(), product.data());
  return product;
}

Eigen::VectorXd symmetric_product(const Eigen::MatrixXd& matrix, const ConstVectorRef& x) {
  constexpr Index in_cache = 32;  // columns that are used twice
  const Eigen::VectorXd subtracted = -x;
  const Index n = matrix.rows();
  Eigen::VectorXd product = Eigen::VectorXd::Zero(n);
  for (Index first = 0; first < n; first += in_cache) {
    const Index own = std::min(in_cache, n - first), next = first + own;
    product.segment(first, own).noalias() +=
        matrix.block(first, first, own, own).selfadjointView<Eigen::Lower>() * x.segment(first, own);
    const Panel below = panel_of(matrix, next, first, n - next, own);
    subtract_product(below, subtracted.data() + first, product.data() + next);
    subtract_transposed_product(below, subtracted.data() + next, product.data() + first);
  }
  return product;
}

void substitute_forward(const Eigen::MatrixXd& factor, VectorRef x) {
  eliminate(panel_of(factor), x.data());
}

void substitute_backward(const Eigen::MatrixXd& factor, VectorRef x) {
  substitute(panel_of(factor), x.data());
}

Eigen::VectorXd solution(const Eigen::MatrixXd& factor, const ConstVectorRef& right) {
  Eigen::VectorXd x = right;
  substitute_forward(factor, x);
  substitute_backward(factor, x);
  return x;
}

}  // namespace creepcontact::linalg
