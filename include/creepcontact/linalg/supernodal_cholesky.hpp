#pragma once
/// Supernodal Cholesky factor of a stiffness matrix (CHOLMOD), with chosen unknowns eliminated last, so that the
/// trailing block L22 of the factor is the Cholesky factor of the Schur complement: S = L22 L22^T.

#include <Eigen/Sparse>
#include <cstdint>
#include <memory>
#include <span>

namespace creepcontact::linalg {

/// Symmetric matrices are given by their lower triangle, compressed columns, sorted rows.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;

/// A pivot that is not positive, or a reciprocal condition estimate below 1e-12 (CHOLMOD itself may report success).
struct SingularMatrix {
  std::int64_t row = -1;  ///< unknown at the failing pivot (smallest pivot if only ill-conditioned), caller's numbering
  double rcond = 0;
};

class SupernodalCholesky {
 public:
  /// Orders and analyses; factorize() must follow.
  /// @param lower     n x n, lower triangle; n may be 0
  /// @param block_of  n entries: unknowns with the same number (the dofs of a node) are ordered as one vertex by METIS
  /// @param trailing  unknowns to be eliminated last, in this order (may be empty)
  /// @throws std::invalid_argument if sizes do not agree or a trailing unknown is named twice; SolverError if memory
  ///         is short
  SupernodalCholesky(const SparseMatrix& lower, std::span<const std::int64_t> block_of,
                     std::span<const std::int64_t> trailing);
  ~SupernodalCholesky();
  SupernodalCholesky(SupernodalCholesky&&) noexcept;
  SupernodalCholesky& operator=(SupernodalCholesky&&) noexcept;

  /// A solver of its own for matrices of the same pattern, without a second analysis; factorize() must follow.
  /// Cost: a copy of the factor. @throws SolverError if memory is short
  SupernodalCholesky same_pattern() const;

  /// Numeric factorisation; the pattern must be the one analysed. All cores are used.
  /// @throws SingularMatrix (a plain struct: the caller knows the body and names it); factorize() may then be called
  ///         again; SolverError if memory is short
  void factorize(const SparseMatrix& lower);

  std::int64_t size() const;
  std::int64_t trailing_size() const;

  /// y = L^-1 P b. The last trailing_size() entries of y belong to the trailing unknowns, in their order.
  /// b and y may be the same array. Cost: one pass through the factor; no allocation. Not safe for two threads on one
  /// object; different objects may be used side by side.
  void forward(std::span<const double> b, std::span<double> y);
  /// x = P^T L^-T y; x and y may be the same array.
  void backward(std::span<const double> y, std::span<double> x);

  /// L22, trailing_size() square, lower triangular (upper part zero). Cost: a copy.
  Eigen::MatrixXd trailing_factor() const;

  /// Bytes of the numeric factor, known after the analysis.
  std::int64_t factor_bytes() const;
  /// Bytes that factorize() takes beside the factor and gives back, known after the analysis.
  std::int64_t work_bytes() const;
  double rcond() const;

 private:
  struct Impl;
  explicit SupernodalCholesky(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace creepcontact::linalg
