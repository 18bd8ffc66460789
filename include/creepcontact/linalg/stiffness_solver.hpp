#pragma once
/// A factored stiffness matrix K = P^T L L^T P with chosen dofs eliminated last. The trailing block L22 of the factor
/// is then the Cholesky factor of their Schur complement: S = L22 L22^T.
/// A solver without a factor approximates K^-1 by a symmetric positive definite linear operator. Its L is the identity,
/// all of it is in backward(), and it has no trailing dofs.

#include <Eigen/SparseCore>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "creepcontact/linalg/task_list.hpp"

namespace creepcontact::linalg {

/// Symmetric matrices are given by their lower triangle, in compressed columns with sorted rows.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;

/// Thrown if a pivot is not positive or the estimated reciprocal condition is below 1e-12 (CHOLMOD itself may then
/// still report success). Not a std::exception: the caller knows the body and names it.
struct SingularMatrix {
  std::int64_t row = -1;  ///< dof of the failing (or smallest) pivot, numbered as by the caller
  double rcond = 0;
};

class GatheredPasses;

enum class PassDirection { forward, backward };

/// A vector of a pass through a factor; both may be the same array.
struct PassVector {
  std::span<const double> from;
  std::span<double> into;
};

/// A solver for one symmetric positive definite matrix, or several of the same pattern. Not safe for concurrent calls
/// on one object; different objects may be used concurrently.
class StiffnessSolver {
 public:
  virtual ~StiffnessSolver() = default;

  /// A new solver for matrices of the same pattern, without a second analysis. factorize() must follow, unless it has
  /// the factor of this one: shared_factor(). @throws SolverError if memory runs out
  virtual std::unique_ptr<StiffnessSolver> same_pattern() const = 0;

  /// Numeric factorisation. @param lower  with the pattern that was analysed
  /// @throws SingularMatrix, after which factorize() may be called again; SolverError if memory runs out
  virtual void factorize(const SparseMatrix& lower) = 0;

  /// Takes the factor of the analysed matrix, if its inputs are known and somebody has computed it (FactorStore).
  /// @returns false: factorize() must be called
  virtual bool take_factor() { return false; }

  /// What solvers have in common that share one factor, in different threads too; null: it is shared with none.
  virtual const void* shared_factor() const { return nullptr; }
  /// Where passes of several threads come together; null: each is made on its own.
  virtual GatheredPasses* gathering() { return nullptr; }

  /// True if the last factorize() found the factor of its matrix computed already (FactorStore).
  virtual bool found_factor() const { return false; }

  virtual std::int64_t size() const = 0;
  virtual std::int64_t trailing_size() const = 0;

  /// y = L^-1 P b. The last trailing_size() entries of y belong to the trailing dofs, in their order. b and y may be
  /// the same array. The bits do not depend on the number of threads. Cost: one pass through the factor.
  void forward(std::span<const double> b, std::span<double> y);
  /// x = P^T L^-T y, the back substitution; x and y may be the same array.
  void backward(std::span<const double> y, std::span<double> x);
  /// forward() and backward() as tasks. The list is valid until the next call.
  virtual TaskList& forward_tasks(std::span<const double> b, std::span<double> y) = 0;
  virtual TaskList& backward_tasks(std::span<const double> y, std::span<double> x) = 0;
  /// Either of them for several vectors at once, for all of which the factor is read once.
  /// @throws std::logic_error if there is no shared_factor()
  virtual TaskList& tasks_of_several(PassDirection direction, std::span<const PassVector> vectors);
  /// Either of them for one or more vectors. Precondition: one, or a shared_factor()
  TaskList& tasks(PassDirection direction, std::span<const PassVector> vectors);

  /// L22, trailing_size() square, lower triangular with a zero upper part. Cost: a copy.
  virtual Eigen::MatrixXd trailing_factor() const = 0;

  /// Bytes of the numeric factor, known after the analysis.
  virtual std::int64_t factor_bytes() const = 0;
  /// Additional temporary bytes of factorize(), known after the analysis.
  virtual std::int64_t work_bytes() const = 0;
  /// Estimate of the reciprocal condition number of the factored matrix; of the preconditioned one without a factor.
  virtual double rcond() const = 0;
  /// Bound on |1 - e| over the eigenvalues e of (approximate K^-1) K: the relative error of a solve in the energy norm.
  /// 0 of a direct solver.
  virtual double error_bound() const { return 0; }
};

/// One solver's part of a pass.
struct Substitution {
  StiffnessSolver* solver;
  std::span<const double> from;
  std::span<double> into;
};
/// Forward or back substitution with the factors of several bodies, whose tasks share the threads. Within
/// GatheredPasses::run() it waits for those of the other threads.
void pass(PassDirection direction, std::span<const Substitution> of_bodies);
inline void forward(std::span<const Substitution> of_bodies) {
  pass(PassDirection::forward, of_bodies);
}
inline void backward(std::span<const Substitution> of_bodies) {
  pass(PassDirection::backward, of_bodies);
}

/// Several vectors for a pass of one solver.
struct SeveralSubstitutions {
  StiffnessSolver* solver;
  std::vector<PassVector> vectors;
};
/// pass() with several vectors for each body; a factor is read once for all of them if it is a shared_factor().
void pass_several(PassDirection direction, std::span<const SeveralSubstitutions> of_bodies);

/// What the entries of a matrix are computed from, as checksums: equal ones have equal matrices, to the last bit.
struct MatrixInputs {
  std::uint64_t geometry = 0, material = 0;
  bool operator==(const MatrixInputs&) const = default;
};

/// A matrix that exists, or one that is made when somebody needs it.
class MatrixOnDemand {
 public:
  /// @param matrix  must outlive the object
  // NOLINTNEXTLINE(google-explicit-constructor): any matrix is one that exists
  MatrixOnDemand(const SparseMatrix& matrix) : make_([&matrix]() -> const SparseMatrix& { return matrix; }) {}
  /// @param make  may be called several times
  explicit MatrixOnDemand(std::function<const SparseMatrix&()> make, MatrixInputs inputs)
      : make_(std::move(make)), inputs_(inputs) {}

  const SparseMatrix& matrix() const { return make_(); }
  operator const SparseMatrix&() const { return make_(); }  // NOLINT(google-explicit-constructor): the reverse
  /// nullopt: not known.
  const std::optional<MatrixInputs>& inputs() const { return inputs_; }

 private:
  std::function<const SparseMatrix&()> make_;
  std::optional<MatrixInputs> inputs_;
};

/// A matrix to be ordered and analysed.
struct StiffnessToAnalyze {
  MatrixOnDemand lower;                    ///< n x n, lower triangle; n may be 0
  std::span<const std::int64_t> block_of;  ///< n entries: dofs with the same number are of the same node
  std::span<const std::int64_t> trailing;  ///< dofs to be eliminated last, in this order; may be empty
  /// The six rigid-body motions of the body without its supports, n x 6, which iterative solvers need; may be null.
  std::function<Eigen::MatrixXd()> rigid_motions = {};
};

/// Orders and analyses a matrix; factorize() must follow.
/// @throws std::invalid_argument if sizes do not match or a trailing dof is named twice; SolverError if memory runs out
using StiffnessSolverFactory = std::function<std::unique_ptr<StiffnessSolver>(const StiffnessToAnalyze&)>;

/// A SupernodalCholesky (CHOLMOD).
std::unique_ptr<StiffnessSolver> default_stiffness_solver(const StiffnessToAnalyze& matrix);

}  // namespace creepcontact::linalg
