#pragma once
/// A factored stiffness matrix K = P^T L L^T P, with chosen unknowns eliminated last, so that the trailing block L22 of
/// the factor is the Cholesky factor of their Schur complement: S = L22 L22^T.

#include <Eigen/SparseCore>
#include <cstdint>
#include <functional>
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

class StiffnessSolver {
 public:
  virtual ~StiffnessSolver() = default;

  /// A solver of its own for matrices of the same pattern, without a second analysis; factorize() must follow.
  /// Cost: a copy of the factor. @throws SolverError if memory is short
  virtual std::unique_ptr<StiffnessSolver> same_pattern() const = 0;

  /// Numeric factorisation; the pattern must be the one analysed.
  /// @throws SingularMatrix (a plain struct: the caller knows the body and names it); factorize() may then be called
  ///         again; SolverError if memory is short
  virtual void factorize(const SparseMatrix& lower) = 0;

  virtual std::int64_t size() const = 0;
  virtual std::int64_t trailing_size() const = 0;

  /// y = L^-1 P b. The last trailing_size() entries of y belong to the trailing unknowns, in their order.
  /// b and y may be the same array. Cost: one pass through the factor; no allocation. Not safe for two threads on one
  /// object; different objects may be used side by side.
  virtual void forward(std::span<const double> b, std::span<double> y) = 0;
  /// x = P^T L^-T y; x and y may be the same array.
  virtual void backward(std::span<const double> y, std::span<double> x) = 0;

  /// L22, trailing_size() square, lower triangular (upper part zero). Cost: a copy.
  virtual Eigen::MatrixXd trailing_factor() const = 0;

  /// Bytes of the numeric factor, known after the analysis.
  virtual std::int64_t factor_bytes() const = 0;
  /// Bytes that factorize() takes in addition and frees again, known after the analysis.
  virtual std::int64_t work_bytes() const = 0;
  virtual double rcond() const = 0;
};

/// Orders and analyses a matrix; factorize() must follow.
/// @param lower     n x n, lower triangle; n may be 0
/// @param block_of  n entries: unknowns with the same number (those of a node) are ordered as one vertex
/// @param trailing  unknowns to be eliminated last, in this order (may be empty)
/// @throws std::invalid_argument if sizes do not agree or a trailing unknown is named twice; SolverError if memory is
///         short
using StiffnessSolverFactory = std::function<std::unique_ptr<StiffnessSolver>(
    const SparseMatrix& lower, std::span<const std::int64_t> block_of, std::span<const std::int64_t> trailing)>;

/// SupernodalCholesky.
std::unique_ptr<StiffnessSolver> default_stiffness_solver(const SparseMatrix& lower,
                                                          std::span<const std::int64_t> block_of,
                                                          std::span<const std::int64_t> trailing);

}  // namespace creepcontact::linalg
