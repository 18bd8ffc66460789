#include "creepcontact/mpi/multigrid_stiffness.hpp"

#include <fmt/format.h>
#include <petscksp.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "block_numbering.hpp"
#include "counting.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/linalg/dense.hpp"
#include "petsc.hpp"

namespace creepcontact::mpi {
namespace {

constexpr int estimating_iterations = 40;                          // of the eigenvalues
constexpr double margin_of_largest = 1.05, margin_of_least = 0.9;  // of the estimates, which lie inside
constexpr int largest_degree = 300;
constexpr double hierarchy = 2.5;  // bytes of all levels, in those of the finest matrix
constexpr double bytes_per_entry = 12;

/// Error of the best polynomial of this degree on [1 / condition, 1].
double chebyshev_error(double condition, int degree) {
  const double root = std::sqrt(condition);
  const double rate = (root - 1) / (root + 1);
  return 2 * std::pow(rate, degree) / (1 + std::pow(rate, 2 * degree));
}

class MultigridStiffness final : public linalg::StiffnessSolver {
 public:
  MultigridStiffness(const linalg::StiffnessToAnalyze& matrix, double error)
      : error_(error),
        numbering_(number_blocks(matrix.lower, matrix.block_of)),
        n_entries_(matrix.lower.matrix().nonZeros()) {
    if (size() == 0) return;
    require_petsc();
    set_pattern(matrix.lower);
    if (matrix.rigid_motions) set_rigid_motions(matrix.rigid_motions());
    make_multigrid();
    check(MatCreateVecs(matrix_.get(), right_.put(), solution_.put()));
    check(VecScatterCreateToAll(solution_.get(), to_all_.put(), whole_.put()));
  }

  std::unique_ptr<StiffnessSolver> same_pattern() const override {
    throw std::logic_error("a multigrid is made for one matrix");
  }

  void factorize(const linalg::SparseMatrix& lower) override {
    if (lower.rows() != size() || lower.nonZeros() != n_entries_)
      throw std::invalid_argument("the pattern is not the one analysed");
    if (size() == 0) return;
    set_values(lower);
    check(PCSetUp(multigrid_.get()));
    choose_degree();
    counted_bytes_.set(static_cast<double>(factor_bytes()));
  }

  std::int64_t size() const override { return std::ssize(numbering_.row_of); }
  std::int64_t trailing_size() const override { return 0; }

  linalg::TaskList& forward_tasks(std::span<const double> b, std::span<double> y) override {
    if (b.data() != y.data()) std::ranges::copy(b, y.begin());
    return nothing_;
  }

  linalg::TaskList& backward_tasks(std::span<const double> y, std::span<double> x) override {
    if (size() == 0) return nothing_;
    sum_parts(y);
    check(KSPSolve(chebyshev_.get(), right_.get(), solution_.get()));
    spread(x);
    return nothing_;
  }

  Eigen::MatrixXd trailing_factor() const override { return {}; }
  std::int64_t factor_bytes() const override {
    return static_cast<std::int64_t>(hierarchy * bytes_per_entry * static_cast<double>(2 * n_entries_));
  }
  std::int64_t work_bytes() const override { return 2 * factor_bytes(); }  // places of the entries, and copies
  double rcond() const override { return rcond_; }
  double error_bound() const override { return error_; }

 private:
  void set_pattern(const linalg::SparseMatrix& lower) {
    std::vector<PetscInt> rows, columns;
    rows.reserve(2 * n_entries_ + std::ssize(numbering_.own_padding));
    columns.reserve(rows.capacity());
    const auto add = [&](std::int64_t row, std::int64_t column) {
      rows.push_back(static_cast<PetscInt>(row));
      columns.push_back(static_cast<PetscInt>(column));
    };
    for_each_entry(lower, [&](std::int64_t row, std::int64_t column, double /*value*/) { add(row, column); });
    for (const std::int64_t row : numbering_.own_padding) add(row, row);
    check(MatCreate(PETSC_COMM_WORLD, matrix_.put()));
    const auto n_own = static_cast<PetscInt>(block_size * numbering_.n_own_blocks);
    check(MatSetSizes(matrix_.get(), n_own, n_own, PETSC_DETERMINE, PETSC_DETERMINE));
    check(MatSetType(matrix_.get(), MATAIJ));
    check(MatSetBlockSize(matrix_.get(), block_size));
    check(MatSetPreallocationCOO(matrix_.get(), std::ssize(rows), rows.data(), columns.data()));
    check(MatSetOption(matrix_.get(), MAT_SPD, PETSC_TRUE));
    check(MatSetOption(matrix_.get(), MAT_SPD_ETERNAL, PETSC_TRUE));
  }

  /// Both triangles. @param use  (row, column, value)
  template <typename Use>
  void for_each_entry(const linalg::SparseMatrix& lower, Use&& use) const {
    for (std::int64_t j = 0; j < lower.outerSize(); ++j)
      for (linalg::SparseMatrix::InnerIterator entry(lower, j); entry; ++entry) {
        const std::int64_t row = numbering_.row_of[entry.row()], column = numbering_.row_of[j];
        use(row, column, entry.value());
        if (row != column) use(column, row, entry.value());
      }
  }

  void set_values(const linalg::SparseMatrix& lower) {
    std::vector<double> values;
    values.reserve(2 * n_entries_ + numbering_.own_padding.size());
    for_each_entry(lower, [&](std::int64_t, std::int64_t, double value) { values.push_back(value); });
    const Eigen::VectorXd diagonal = lower.diagonal();
    const double usual = diagonal.size() > 0 && diagonal.maxCoeff() > 0 ? diagonal.maxCoeff() : 1;
    values.insert(values.end(), numbering_.own_padding.size(), usual);
    check(MatSetValuesCOO(matrix_.get(), values.data(), INSERT_VALUES));
  }

  /// Orthonormal vectors that span these, as the coarse levels' spaces.
  void set_rigid_motions(const Eigen::MatrixXd& motions) {
    constexpr double rank_tolerance = 1e-10;
    const linalg::SingularValues all = linalg::singular_values(motions);
    const Index n = (all.values.array() > rank_tolerance * all.values[0]).count();
    const Eigen::MatrixXd basis = all.left.leftCols(n);
    std::vector<OwnedVec> vectors(n);
    std::vector<Vec> handles;
    for (Index k = 0; k < n; ++k) {
      check(MatCreateVecs(matrix_.get(), nullptr, vectors[k].put()));
      set_own(vectors[k].get(), [&](std::int64_t unknown) { return basis(unknown, k); });
      handles.push_back(vectors[k].get());
    }
    OwnedNullSpace space;
    check(MatNullSpaceCreate(PETSC_COMM_WORLD, PETSC_FALSE, static_cast<PetscInt>(n), handles.data(), space.put()));
    check(MatSetNearNullSpace(matrix_.get(), space.get()));
  }

  /// @param value  of an unknown, on its owner
  template <typename Value>
  void set_own(Vec vector, Value&& value) const {
    PetscInt first = 0, end = 0;
    check(VecGetOwnershipRange(vector, &first, &end));
    double* entries = nullptr;
    check(VecSet(vector, 0));
    check(VecGetArray(vector, &entries));
    for (std::int64_t i = 0; i < size(); ++i)
      if (const std::int64_t row = numbering_.row_of[i]; row >= first && row < end) entries[row - first] = value(i);
    check(VecRestoreArray(vector, &entries));
  }

  void make_multigrid() {
    check(PCCreate(PETSC_COMM_WORLD, multigrid_.put()));
    check(PCSetType(multigrid_.get(), PCGAMG));
    check(PCGAMGSetReuseInterpolation(multigrid_.get(), PETSC_TRUE));
    check(PCSetOperators(multigrid_.get(), matrix_.get(), matrix_.get()));
    check(PCSetFromOptions(multigrid_.get()));
  }

  /// Estimates by conjugate gradients on a rough right-hand side; {0, 1} if they break down.
  std::pair<double, double> extreme_eigenvalues() {
    OwnedKSP cg;
    check(KSPCreate(PETSC_COMM_WORLD, cg.put()));
    check(KSPSetType(cg.get(), KSPCG));
    check(KSPSetPC(cg.get(), multigrid_.get()));
    check(KSPSetOperators(cg.get(), matrix_.get(), matrix_.get()));
    check(KSPSetTolerances(cg.get(), 1e-12, 0, PETSC_DEFAULT, estimating_iterations));
    check(KSPSetComputeSingularValues(cg.get(), PETSC_TRUE));
    set_own(right_.get(), [](std::int64_t unknown) {
      constexpr double golden = 0.6180339887498949, turns = 1e3;
      const double place = turns * golden * static_cast<double>(unknown) * static_cast<double>(unknown % 1013);
      return place - std::floor(place) - 0.5;
    });
    check(KSPSolve(cg.get(), right_.get(), solution_.get()));
    KSPConvergedReason reason{};
    check(KSPGetConvergedReason(cg.get(), &reason));
    if (reason < 0 && reason != KSP_DIVERGED_ITS) return {0, 1};
    double largest = 0, least = 0;
    check(KSPComputeExtremeSingularValues(cg.get(), &largest, &least));
    return {least * margin_of_least, largest * margin_of_largest};
  }

  void choose_degree() {
    const auto [least, largest] = extreme_eigenvalues();
    const double condition = least > 0 ? largest / least : std::numeric_limits<double>::infinity();
    rcond_ = 1 / condition;
    int degree = 1;
    while (degree <= largest_degree && !(chebyshev_error(condition, degree) <= error_)) ++degree;
    if (degree > largest_degree)
      throw SolverError(
          fmt::format("the multigrid of the stiffness converges too slowly (condition {:.3g}); a body may be held at "
                      "too few nodes, or its elements are very thin or almost incompressible: use linear_solver.method "
                      "= \"direct\"",
                      condition));
    log::info("multigrid: {} cycles per solve of {} unknowns (condition {:.3g})", degree, size(), condition);
    chebyshev_.reset();
    check(KSPCreate(PETSC_COMM_WORLD, chebyshev_.put()));
    check(KSPSetType(chebyshev_.get(), KSPCHEBYSHEV));
    check(KSPSetPC(chebyshev_.get(), multigrid_.get()));
    check(KSPSetOperators(chebyshev_.get(), matrix_.get(), matrix_.get()));
    check(KSPChebyshevSetEigenvalues(chebyshev_.get(), largest, least));
    check(KSPSetNormType(chebyshev_.get(), KSP_NORM_NONE));
    check(KSPSetConvergenceTest(chebyshev_.get(), KSPConvergedSkip, nullptr, nullptr));
    check(KSPSetTolerances(chebyshev_.get(), PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT, degree));
  }

  void sum_parts(std::span<const double> own) {
    check(VecSet(right_.get(), 0));
    rows_.clear();
    values_.clear();
    for (std::size_t i = 0; i < own.size(); ++i)
      if (own[i] != 0) {
        rows_.push_back(static_cast<PetscInt>(numbering_.row_of[i]));
        values_.push_back(own[i]);
      }
    check(VecSetValues(right_.get(), static_cast<PetscInt>(rows_.size()), rows_.data(), values_.data(), ADD_VALUES));
    check(VecAssemblyBegin(right_.get()));
    check(VecAssemblyEnd(right_.get()));
  }

  void spread(std::span<double> x) {
    check(VecScatterBegin(to_all_.get(), solution_.get(), whole_.get(), INSERT_VALUES, SCATTER_FORWARD));
    check(VecScatterEnd(to_all_.get(), solution_.get(), whole_.get(), INSERT_VALUES, SCATTER_FORWARD));
    const double* all = nullptr;
    check(VecGetArrayRead(whole_.get(), &all));
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = all[numbering_.row_of[i]];
    check(VecRestoreArrayRead(whole_.get(), &all));
  }

  double error_;
  BlockNumbering numbering_;
  std::int64_t n_entries_;  // of the lower triangle of this process
  OwnedMat matrix_;
  OwnedPC multigrid_;
  OwnedKSP chebyshev_;
  OwnedVec right_, solution_, whole_;
  OwnedScatter to_all_;
  double rcond_ = 0;
  CountedBytes counted_bytes_;
  std::vector<PetscInt> rows_;  // scratch
  std::vector<double> values_;
  linalg::SingleTask nothing_;
};

}  // namespace

linalg::StiffnessSolverFactory multigrid_stiffness(double error) {
  return
      [error](const linalg::StiffnessToAnalyze& matrix) { return std::make_unique<MultigridStiffness>(matrix, error); };
}

}  // namespace creepcontact::mpi
