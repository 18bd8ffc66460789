#include "supernodal_cholesky.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "blas_threads.hpp"
#include "cholmod_context.hpp"
#include "creepcontact/base/index.hpp"
#include "ordering.hpp"
#include "supernodal_pass.hpp"

namespace creepcontact::linalg {

namespace {

constexpr double min_rcond = 1e-12;

void check_arguments(const SparseMatrix& lower, std::span<const std::int64_t> block_of,
                     std::span<const std::int64_t> trailing) {
  if (lower.rows() != lower.cols()) throw std::invalid_argument("the matrix must be square");
  if (!lower.isCompressed()) throw std::invalid_argument("the matrix must be compressed");
  if (std::ssize(block_of) != lower.rows()) throw std::invalid_argument("one block number per unknown is needed");
  std::vector<bool> seen(block_of.size(), false);
  for (const std::int64_t unknown : trailing) {
    if (unknown < 0 || unknown >= lower.rows()) throw std::invalid_argument("trailing unknown outside the matrix");
    if (seen[unknown]) throw std::invalid_argument("trailing unknown named twice");
    seen[unknown] = true;
  }
}

}  // namespace

/// Order, pattern and supernodes: what all factors of a pattern share. It does not change.
struct SupernodalCholesky::Analysis {
  Analysis(const SparseMatrix& lower, std::span<const std::int64_t> block_of, std::span<const std::int64_t> trailing);
  Supernodes supernodes() const {
    const std::size_t n = factor->nsuper + 1;
    return {.first_column = {integers(factor->super), n},
            .first_row = {integers(factor->pi), n},
            .first_value = {integers(factor->px), n},
            .rows = {integers(factor->s), factor->ssize},
            .permutation = {integers(factor->Perm), factor->n}};
  }

  CholmodContext context;
  FactorPointer factor{nullptr, FreeFactor{nullptr}};  // symbolic; null for an empty matrix
  std::int64_t n_entries;
  std::int64_t n_trailing;
};

SupernodalCholesky::Analysis::Analysis(const SparseMatrix& lower, std::span<const std::int64_t> block_of,
                                       std::span<const std::int64_t> trailing)
    : n_entries(lower.nonZeros()), n_trailing(std::ssize(trailing)) {
  if (lower.rows() == 0) return;  // no factor; CHOLMOD takes no empty matrix
  const std::vector<std::int64_t> order = elimination_order(lower, block_of, trailing, context);
  const SparseMatrix links = missing_links(lower, order, trailing.size(), context);
  const SparseMatrix linked = links.nonZeros() > 0 ? SparseMatrix(lower + links) : SparseMatrix();
  cholmod_sparse pattern = view(links.nonZeros() > 0 ? linked : lower);
  pattern.xtype = CHOLMOD_PATTERN;
  factor = FactorPointer(cholmod_l_analyze_p(&pattern, cholmod_integers(order.data()), nullptr, 0, context.get()),
                         {context.get()});
  context.check("analyse");
  if (!std::equal(trailing.begin(), trailing.end(), integers(factor->Perm) + (lower.rows() - n_trailing))) {
    throw std::logic_error("CHOLMOD moved the trailing unknowns");
  }
}

/// The entries of a factor. Several solvers may have one; then it does not change.
struct SupernodalCholesky::Factor {
  explicit Factor(const Analysis& analysis)
      : factor(cholmod_l_copy_factor(analysis.factor.get(), context.get()), {context.get()}) {
    context.check("copy the analysis of");
  }
  /// @throws SingularMatrix
  void compute(const SparseMatrix& lower);
  const double* entries() const { return static_cast<const double*>(factor->x); }
  template <typename Visit>
  void for_each_column(std::int64_t first, Visit visit) const;
  std::int64_t weakest_row() const;

  CholmodContext context;
  FactorPointer factor;
  double rcond = 0;
};

void SupernodalCholesky::Factor::compute(const SparseMatrix& lower) {
  rcond = 0;
  cholmod_sparse matrix = view(lower);
  {
    const BlasFactorization all_cores;
    cholmod_l_factorize(&matrix, factor.get(), context.get());
  }
  context.check("factorise");
  // A failed pivot is a warning to CHOLMOD; round-off may also carry it past the pivots of a singular matrix.
  if (factor->minor < factor->n) throw SingularMatrix{integers(factor->Perm)[factor->minor], 0};
  const double estimate = cholmod_l_rcond(factor.get(), context.get());
  if (!(estimate >= min_rcond)) throw SingularMatrix{weakest_row(), estimate};
  rcond = estimate;
}

/// visit(column, rows, values): rows and values of the factor's column from its diagonal on.
template <typename Visit>
void SupernodalCholesky::Factor::for_each_column(std::int64_t first, Visit visit) const {
  const std::int64_t *start = integers(factor->super), *row_start = integers(factor->pi),
                     *value_start = integers(factor->px), *rows = integers(factor->s);
  const double* values = static_cast<const double*>(factor->x);
  for (std::size_t s = 0; s < factor->nsuper; ++s) {
    const std::int64_t n_rows = row_start[s + 1] - row_start[s];
    for (std::int64_t column = std::max(first, start[s]); column < start[s + 1]; ++column) {
      const std::int64_t k = column - start[s];  // the columns of a supernode are the first of its rows
      const auto length = n_rows - k;
      visit(column, std::span(rows + row_start[s] + k, length),
            std::span(values + value_start[s] + k * (n_rows + 1), length));
    }
  }
}

std::int64_t SupernodalCholesky::Factor::weakest_row() const {
  std::int64_t weakest = 0;
  double least = HUGE_VAL;
  for_each_column(0, [&](std::int64_t column, auto, std::span<const double> values) {
    if (std::isnan(least) || values[0] >= least) return;
    least = values[0];
    weakest = column;
  });
  return integers(factor->Perm)[weakest];
}

SupernodalCholesky::SupernodalCholesky(const SparseMatrix& lower, std::span<const std::int64_t> block_of,
                                       std::span<const std::int64_t> trailing) {
  check_arguments(lower, block_of, trailing);
  analysis_ = std::make_shared<const Analysis>(lower, block_of, trailing);
  prepare_passes();
}

SupernodalCholesky::SupernodalCholesky(const SupernodalCholesky& other)
    : StiffnessSolver(other), analysis_(other.analysis_), factor_(other.factor_) {
  prepare_passes();
}

SupernodalCholesky::SupernodalCholesky(SupernodalCholesky&&) noexcept = default;
SupernodalCholesky& SupernodalCholesky::operator=(SupernodalCholesky&&) noexcept = default;
SupernodalCholesky::~SupernodalCholesky() = default;

std::unique_ptr<StiffnessSolver> SupernodalCholesky::same_pattern() const {
  return std::unique_ptr<StiffnessSolver>(new SupernodalCholesky(*this));
}

std::unique_ptr<StiffnessSolver> default_stiffness_solver(const StiffnessToAnalyze& matrix) {
  return std::make_unique<SupernodalCholesky>(matrix.lower, matrix.block_of, matrix.trailing);
}

void SupernodalCholesky::prepare_passes() {
  if (!is_empty()) passes_ = std::make_unique<SupernodalPass>(analysis_->supernodes());
}

bool SupernodalCholesky::is_empty() const {
  return !analysis_->factor;
}

void SupernodalCholesky::factorize(const SparseMatrix& lower) {
  if (is_empty() && lower.rows() == 0) return;
  if (is_empty() || lower.rows() != static_cast<Index>(analysis_->factor->n) ||
      lower.nonZeros() != analysis_->n_entries || !lower.isCompressed()) {
    throw std::invalid_argument("the pattern is not the one analysed");
  }
  // Nobody else can take what this one alone has: no other thread copies it meanwhile.
  std::shared_ptr<Factor> computed =
      factor_.use_count() == 1 ? std::move(factor_) : std::make_shared<Factor>(*analysis_);
  factor_.reset();
  computed->compute(lower);
  factor_ = std::move(computed);
}

std::int64_t SupernodalCholesky::size() const {
  return is_empty() ? 0 : static_cast<std::int64_t>(analysis_->factor->n);
}
std::int64_t SupernodalCholesky::trailing_size() const {
  return analysis_->n_trailing;
}

/// `from`, or a copy of it if `into` is the same array.
std::span<const double> SupernodalCholesky::apart(std::span<const double> from, std::span<double> into,
                                                  std::size_t vector) {
  if (from.data() != into.data()) return from;
  if (copies_.size() <= vector) copies_.resize(vector + 1);
  copies_[vector].assign(from.begin(), from.end());
  return copies_[vector];
}

TaskList& SupernodalCholesky::forward_tasks(std::span<const double> b, std::span<double> y) {
  const PassVector vector{b, y};
  return tasks_of_several(PassDirection::forward, {&vector, 1});
}

TaskList& SupernodalCholesky::backward_tasks(std::span<const double> y, std::span<double> x) {
  const PassVector vector{y, x};
  return tasks_of_several(PassDirection::backward, {&vector, 1});
}

TaskList& SupernodalCholesky::tasks_of_several(PassDirection direction, std::span<const PassVector> vectors) {
  if (is_empty()) return nothing_;
  if (!factor_) throw std::logic_error("a pass before the factorisation");
  std::vector<std::span<const double>> from;
  std::vector<std::span<double>> into;
  from.reserve(vectors.size());
  into.reserve(vectors.size());
  for (std::size_t v = 0; v < vectors.size(); ++v) {
    from.push_back(apart(vectors[v].from, vectors[v].into, v));
    into.push_back(vectors[v].into);
  }
  return direction == PassDirection::forward ? passes_->forward(factor_->entries(), from, into)
                                             : passes_->backward(factor_->entries(), from, into);
}

Eigen::MatrixXd SupernodalCholesky::trailing_factor() const {
  if (is_empty()) return {};
  const std::int64_t first = size() - trailing_size();
  Eigen::MatrixXd block = Eigen::MatrixXd::Zero(trailing_size(), trailing_size());
  factor_->for_each_column(
      first, [&](std::int64_t column, std::span<const std::int64_t> rows, std::span<const double> values) {
        for (std::size_t i = 0; i < rows.size(); ++i) block(rows[i] - first, column - first) = values[i];
      });
  return block;
}

std::int64_t SupernodalCholesky::factor_bytes() const {
  return is_empty() ? 0 : static_cast<std::int64_t>(analysis_->factor->xsize * sizeof(double));
}
std::int64_t SupernodalCholesky::work_bytes() const {
  if (is_empty()) return 0;
  // Update matrices of supernodes, and the matrix in the order of the factor, twice.
  return static_cast<std::int64_t>(analysis_->factor->maxcsize * sizeof(double)) +
         2 * analysis_->n_entries * static_cast<std::int64_t>(sizeof(double) + sizeof(std::int64_t));
}
double SupernodalCholesky::rcond() const {
  return is_empty() ? 1 : factor_ ? factor_->rcond : 0;
}

}  // namespace creepcontact::linalg
