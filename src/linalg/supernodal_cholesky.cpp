#include "supernodal_cholesky.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
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

struct SupernodalCholesky::Impl {
  Impl(const SparseMatrix& lower, std::span<const std::int64_t> block_of, std::span<const std::int64_t> trailing);
  Impl(const Impl& analysed);
  void factorize(const SparseMatrix& lower);
  void prepare_passes();
  /// `from`, or a copy of it if `into` is the same array.
  std::span<const double> apart(std::span<const double> from, std::span<double> into);

  std::int64_t* permutation() const { return integers(factor->Perm); }
  template <typename Visit>
  void for_each_column(std::int64_t first, Visit visit) const;
  std::int64_t weakest_row() const;

  CholmodContext context;
  FactorPointer factor{nullptr, FreeFactor{nullptr}};
  std::int64_t n_entries;
  std::int64_t n_trailing;
  double rcond = 0;
  std::optional<SupernodalPass> passes;
  SingleTask nothing;
  std::vector<double> copy;
};

SupernodalCholesky::Impl::Impl(const SparseMatrix& lower, std::span<const std::int64_t> block_of,
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
  if (!std::equal(trailing.begin(), trailing.end(), permutation() + (lower.rows() - n_trailing))) {
    throw std::logic_error("CHOLMOD moved the trailing unknowns");
  }
  prepare_passes();
}

SupernodalCholesky::Impl::Impl(const Impl& analysed) : n_entries(analysed.n_entries), n_trailing(analysed.n_trailing) {
  if (!analysed.factor) return;
  factor = FactorPointer(cholmod_l_copy_factor(analysed.factor.get(), context.get()), {context.get()});
  context.check("copy the factor of");
  prepare_passes();
}

void SupernodalCholesky::Impl::prepare_passes() {
  const std::size_t n = factor->nsuper + 1;
  passes.emplace(Supernodes{.first_column = {integers(factor->super), n},
                            .first_row = {integers(factor->pi), n},
                            .first_value = {integers(factor->px), n},
                            .rows = {integers(factor->s), factor->ssize},
                            .permutation = {permutation(), factor->n}});
}

std::span<const double> SupernodalCholesky::Impl::apart(std::span<const double> from, std::span<double> into) {
  if (from.data() != into.data()) return from;
  copy.assign(from.begin(), from.end());
  return copy;
}

void SupernodalCholesky::Impl::factorize(const SparseMatrix& lower) {
  if (!factor && lower.rows() == 0) {
    rcond = 1;
    return;
  }
  if (!factor || lower.rows() != static_cast<Index>(factor->n) || lower.nonZeros() != n_entries ||
      !lower.isCompressed()) {
    throw std::invalid_argument("the pattern is not the one analysed");
  }
  rcond = 0;
  cholmod_sparse matrix = view(lower);
  {
    const BlasFactorization all_cores;
    cholmod_l_factorize(&matrix, factor.get(), context.get());
  }
  context.check("factorise");
  // A failed pivot is a warning to CHOLMOD; round-off may also carry it past the pivots of a singular matrix.
  if (factor->minor < factor->n) throw SingularMatrix{permutation()[factor->minor], 0};
  const double estimate = cholmod_l_rcond(factor.get(), context.get());
  if (!(estimate >= min_rcond)) throw SingularMatrix{weakest_row(), estimate};
  rcond = estimate;
}

/// visit(column, rows, values): rows and values of the factor's column from its diagonal on.
template <typename Visit>
void SupernodalCholesky::Impl::for_each_column(std::int64_t first, Visit visit) const {
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

std::int64_t SupernodalCholesky::Impl::weakest_row() const {
  std::int64_t weakest = 0;
  double least = HUGE_VAL;
  for_each_column(0, [&](std::int64_t column, auto, std::span<const double> values) {
    if (std::isnan(least) || values[0] >= least) return;
    least = values[0];
    weakest = column;
  });
  return permutation()[weakest];
}

SupernodalCholesky::SupernodalCholesky(const SparseMatrix& lower, std::span<const std::int64_t> block_of,
                                       std::span<const std::int64_t> trailing) {
  check_arguments(lower, block_of, trailing);
  impl_ = std::make_unique<Impl>(lower, block_of, trailing);
}

SupernodalCholesky::SupernodalCholesky(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

std::unique_ptr<StiffnessSolver> SupernodalCholesky::same_pattern() const {
  return std::unique_ptr<StiffnessSolver>(new SupernodalCholesky(std::make_unique<Impl>(*impl_)));
}

std::unique_ptr<StiffnessSolver> default_stiffness_solver(const StiffnessToAnalyze& matrix) {
  return std::make_unique<SupernodalCholesky>(matrix.lower, matrix.block_of, matrix.trailing);
}

SupernodalCholesky::~SupernodalCholesky() = default;
SupernodalCholesky::SupernodalCholesky(SupernodalCholesky&&) noexcept = default;
SupernodalCholesky& SupernodalCholesky::operator=(SupernodalCholesky&&) noexcept = default;

void SupernodalCholesky::factorize(const SparseMatrix& lower) {
  impl_->factorize(lower);
}

std::int64_t SupernodalCholesky::size() const {
  return impl_->factor ? static_cast<std::int64_t>(impl_->factor->n) : 0;
}
std::int64_t SupernodalCholesky::trailing_size() const {
  return impl_->n_trailing;
}

TaskList& SupernodalCholesky::forward_tasks(std::span<const double> b, std::span<double> y) {
  if (!impl_->factor) return impl_->nothing;
  return impl_->passes->forward(static_cast<const double*>(impl_->factor->x), impl_->apart(b, y), y);
}

TaskList& SupernodalCholesky::backward_tasks(std::span<const double> y, std::span<double> x) {
  if (!impl_->factor) return impl_->nothing;
  return impl_->passes->backward(static_cast<const double*>(impl_->factor->x), impl_->apart(y, x), x);
}

Eigen::MatrixXd SupernodalCholesky::trailing_factor() const {
  if (!impl_->factor) return {};
  const std::int64_t first = size() - trailing_size();
  Eigen::MatrixXd block = Eigen::MatrixXd::Zero(trailing_size(), trailing_size());
  impl_->for_each_column(first,
                         [&](std::int64_t column, std::span<const std::int64_t> rows, std::span<const double> values) {
                           for (std::size_t i = 0; i < rows.size(); ++i)
                             block(rows[i] - first, column - first) = values[i];
                         });
  return block;
}

std::int64_t SupernodalCholesky::factor_bytes() const {
  return impl_->factor ? static_cast<std::int64_t>(impl_->factor->xsize * sizeof(double)) : 0;
}
std::int64_t SupernodalCholesky::work_bytes() const {
  if (!impl_->factor) return 0;
  // Update matrices of supernodes, and the matrix in the order of the factor, twice.
  return static_cast<std::int64_t>(impl_->factor->maxcsize * sizeof(double)) +
         2 * impl_->n_entries * static_cast<std::int64_t>(sizeof(double) + sizeof(std::int64_t));
}
double SupernodalCholesky::rcond() const {
  return impl_->rcond;
}

}  // namespace creepcontact::linalg
