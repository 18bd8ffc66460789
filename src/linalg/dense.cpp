#include "creepcontact/linalg/dense.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/blas_address_space.hpp"
#include "lapack.hpp"

namespace creepcontact::linalg {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Without room for its buffer OpenBLAS would try for ever to get it. It keeps the buffer: one look is enough.
/// @throws std::bad_alloc
void expect_room_for_buffer() {
  static const bool has_room = [] {
    const auto bytes = static_cast<std::size_t>(blas_address_space(1));
    if (bytes == 0) return true;
    void* const room = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (room == MAP_FAILED) throw std::bad_alloc();
    munmap(room, bytes);
    return true;
  }();
  static_cast<void>(has_room);
}

int size(Index n) {
  return static_cast<int>(n);
}
/// Distance of the columns of an array with so many rows: LAPACK wants at least 1.
int stride(Index rows) {
  return std::max(1, size(rows));
}

/// Calls routine(work, n_work, info) first for the size of the work space, then with it. @return  true on success
template <typename Routine>
bool call(const Routine& routine) {
  expect_room_for_buffer();
  double best = 0;
  int n_work = -1, info = 0;
  routine(&best, &n_work, &info);
  n_work = std::max(1, static_cast<int>(best));
  std::vector<double> work(static_cast<std::size_t>(n_work));
  routine(work.data(), &n_work, &info);
  return info == 0;
}

/// A^-1 result. @param factor  A, overwritten @param is_positive  A is symmetric and positive definite
template <typename Matrix, typename Right>
Right solved(Matrix factor, Right result, bool is_positive) {
  expect_room_for_buffer();
  const int n = size(factor.rows()), n_right = size(result.cols()), step = stride(n);
  Eigen::Matrix<int, Matrix::RowsAtCompileTime, 1> pivots(factor.rows());
  int info = 0;
  if (is_positive)
    dposv_("L", &n, &n_right, factor.data(), &step, result.data(), &step, &info, 1);
  else
    dgesv_(&n, &n_right, factor.data(), &step, pivots.data(), result.data(), &step, &info);
  if (info != 0) result.setConstant(nan);
  return result;
}

/// A = Q R: R in the upper triangle, what makes Q below it.
struct Reflections {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd tau;
};
Reflections reflections(const Eigen::MatrixXd& matrix) {
  Reflections result{matrix, Eigen::VectorXd::Zero(std::min(matrix.rows(), matrix.cols()))};
  const int m = size(matrix.rows()), n = size(matrix.cols()), step = stride(matrix.rows());
  call([&](double* work, const int* n_work, int* info) {
    dgeqrf_(&m, &n, result.matrix.data(), &step, result.tau.data(), work, n_work, info);
  });
  return result;
}

/// @param all_right  all right vectors and no left ones, else min(rows, columns) of both
SingularValues decomposed(Eigen::MatrixXd matrix, bool all_right) {
  const int m = size(matrix.rows()), n = size(matrix.cols()), k = std::min(m, n), n_right = all_right ? n : k;
  Eigen::MatrixXd left(m, all_right ? 0 : k), right(n_right, n);
  Eigen::VectorXd values(k);
  const int step = stride(m), left_step = stride(m), right_step = stride(n_right);
  const bool done = call([&](double* work, const int* n_work, int* info) {
    dgesvd_(all_right ? "N" : "S", all_right ? "A" : "S", &m, &n, matrix.data(), &step, values.data(), left.data(),
            &left_step, right.data(), &right_step, work, n_work, info, 1, 1);
  });
  if (!done) values.setConstant(nan);
  return {std::move(left), std::move(values), right.transpose()};
}

}  // namespace

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& matrix) {
  SymmetricEigen result{Eigen::VectorXd(matrix.cols()), matrix};
  const int n = size(matrix.cols()), step = stride(n);
  const bool done = call([&](double* work, const int* n_work, int* info) {
    dsyev_("V", "L", &n, result.vectors.data(), &step, result.values.data(), work, n_work, info, 1, 1);
  });
  if (!done) result.values.setConstant(nan);
  return result;
}

Tensor6 eigenvalue_ratios(const Matrix6& a, const Matrix6& b) {
  Matrix6 left = a, right = b;
  Tensor6 values;
  const int type = 1, n = 6;
  const bool done = call([&](double* work, const int* n_work, int* info) {
    dsygv_(&type, "N", "L", &n, left.data(), &n, right.data(), &n, values.data(), work, n_work, info, 1, 1);
  });
  if (!done) values.setConstant(nan);
  return values;
}

Eigen::MatrixXd symmetric_pseudo_inverse(const Eigen::MatrixXd& matrix, double relative_limit) {
  const SymmetricEigen eigen = symmetric_eigen(matrix);
  double limit = 0;
  for (const double value : eigen.values) limit = std::max(limit, relative_limit * std::abs(value));
  Eigen::MatrixXd scaled = eigen.vectors;
  for (Index i = 0; i < scaled.cols(); ++i) scaled.col(i) *= eigen.values[i] > limit ? 1 / eigen.values[i] : 0.0;
  return scaled * eigen.vectors.transpose();
}
Matrix3 symmetric_pseudo_inverse(const Matrix3& matrix, double relative_limit) {
  return symmetric_pseudo_inverse(Eigen::MatrixXd(matrix), relative_limit);
}

SingularValues singular_values(const Eigen::MatrixXd& matrix) {
  if (matrix.size() == 0) return {Eigen::MatrixXd(matrix.rows(), 0), {}, Eigen::MatrixXd(matrix.cols(), 0)};
  return decomposed(matrix, false);
}

Eigen::MatrixXd triangular_factor(const Eigen::MatrixXd& matrix) {
  const Eigen::MatrixXd factor = reflections(matrix).matrix;
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(std::min(matrix.rows(), matrix.cols()), matrix.cols());
  for (Index j = 0; j < result.cols(); ++j)
    for (Index i = 0; i <= std::min(j, result.rows() - 1); ++i) result(i, j) = factor(i, j);
  return result;
}

RightSingularVectors right_singular_vectors(const Eigen::MatrixXd& matrix) {
  const Index n = matrix.cols();
  Eigen::MatrixXd square = Eigen::MatrixXd::Zero(n, n);
  if (matrix.rows() > 0) square.topRows(std::min(matrix.rows(), n)) = triangular_factor(matrix);
  SingularValues svd = decomposed(std::move(square), true);
  return {std::move(svd.values), std::move(svd.right)};
}

Eigen::MatrixXd null_space(const Eigen::MatrixXd& matrix, double tolerance) {
  if (matrix.rows() == 0) return Eigen::MatrixXd::Identity(matrix.cols(), matrix.cols());
  const RightSingularVectors right = right_singular_vectors(matrix);
  const double limit = tolerance * std::max(1.0, right.values[0]);
  const Index rank = std::ranges::count_if(right.values, [limit](double value) { return value > limit; });
  return right.vectors.rightCols(matrix.cols() - rank);
}

Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& columns) {
  Reflections result = reflections(columns);
  const int m = size(columns.rows()), n = size(columns.cols()), step = stride(m);
  call([&](double* work, const int* n_work, int* info) {
    dorgqr_(&m, &n, &n, result.matrix.data(), &step, result.tau.data(), work, n_work, info);
  });
  return result.matrix;
}

Eigen::VectorXi column_pivots(const Eigen::MatrixXd& matrix) {
  Eigen::MatrixXd factor = matrix;
  Eigen::VectorXi pivots = Eigen::VectorXi::Zero(matrix.cols());
  std::vector<double> tau(static_cast<std::size_t>(matrix.cols()));
  const int m = size(matrix.rows()), n = size(matrix.cols()), step = stride(m);
  call([&](double* work, const int* n_work, int* info) {
    dgeqp3_(&m, &n, factor.data(), &step, pivots.data(), tau.data(), work, n_work, info);
  });
  for (int& pivot : pivots) --pivot;
  return pivots;
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix) {
  return solved(matrix, Eigen::MatrixXd::Identity(matrix.rows(), matrix.rows()).eval(), false);
}
Matrix6 inverse(const Matrix6& matrix) {
  return solved(matrix, Matrix6::Identity().eval(), false);
}
Matrix6 inverse_of_positive(const Matrix6& matrix) {
  return solved(matrix, Matrix6::Identity().eval(), true);
}
Eigen::MatrixXd solve_positive(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
  return solved(matrix, right, true);
}
Tensor6 solve_positive(const Matrix6& matrix, const Tensor6& right) {
  return solved(matrix, right, true);
}

void substitute_forward_in_all(const Eigen::MatrixXd& factor, Eigen::MatrixXd& columns) {
  expect_room_for_buffer();
  const int n = size(columns.rows()), n_columns = size(columns.cols()), step = stride(n);
  const double one = 1;
  if (columns.size() > 0)
    dtrsm_("L", "L", "N", "N", &n, &n_columns, &one, factor.data(), &step, columns.data(), &step, 1, 1, 1, 1);
}

Eigen::MatrixXd products_of_columns(const Eigen::MatrixXd& columns) {
  expect_room_for_buffer();
  const int n = size(columns.cols()), k = size(columns.rows()), step = stride(k), step_of_product = stride(n);
  const double one = 1, zero = 0;
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(n, n);
  if (columns.size() > 0)
    dsyrk_("L", "T", &n, &k, &one, columns.data(), &step, &zero, products.data(), &step_of_product, 1, 1);
  return products.selfadjointView<Eigen::Lower>();
}

Eigen::MatrixXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right, double threshold) {
  const int m = size(matrix.rows()), n = size(matrix.cols()), n_right = size(right.cols());
  // Round-off in a factor of a singular matrix is some units of the last place times the number of entries summed.
  if (threshold <= 0) threshold = 10 * std::numeric_limits<double>::epsilon() * std::max(m, n);
  Eigen::MatrixXd factor = matrix, solution = Eigen::MatrixXd::Zero(std::max(m, n), n_right);
  solution.topRows(m) = right;
  const int step = stride(m), solution_step = stride(solution.rows());
  std::vector<int> pivots(static_cast<std::size_t>(n));
  int rank = 0;
  const bool done = call([&](double* work, const int* n_work, int* info) {
    dgelsy_(&m, &n, &n_right, factor.data(), &step, solution.data(), &solution_step, pivots.data(), &threshold, &rank,
            work, n_work, info);
  });
  if (!done) solution.setConstant(nan);
  return solution.topRows(n);
}

}  // namespace creepcontact::linalg
