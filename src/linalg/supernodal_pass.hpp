#pragma once
/// Forward and back substitution with a supernodal factor, in tasks for several threads. The elimination tree is cut
/// into subtrees, one task each. The supernodes above them are cut into panels of columns, one task each, which start
/// as soon as the panel before has done the rows that they need. The cuts do not depend on the number of threads, and
/// every sum has one order, so the bits do not either. They do depend on the number of vectors of a pass.
/// Source: the multifrontal way of passing updates up the tree, Liu (1992); here of vectors.

#include <memory>
#include <span>
#include <vector>

#include "creepcontact/linalg/task_list.hpp"

namespace creepcontact::linalg {

/// The pattern of a supernodal factor. The columns of supernode s are first_column[s] .. first_column[s+1]-1, its rows
/// rows[first_row[s]] .. (those of the columns first, then ascending), its entries a column-major array of these rows
/// and columns from first_value[s] on. Supernodes are postordered.
struct Supernodes {
  std::span<const std::int64_t> first_column, first_row, first_value;  // one more than supernodes
  std::span<const std::int64_t> rows;
  std::span<const std::int64_t> permutation;  // the caller's number of each column

  std::int64_t size() const { return std::ssize(first_column) - 1; }
  std::int64_t n_columns(std::int64_t s) const { return first_column[s + 1] - first_column[s]; }
  std::int64_t n_rows(std::int64_t s) const { return first_row[s + 1] - first_row[s]; }
  std::int64_t n_below(std::int64_t s) const { return n_rows(s) - n_columns(s); }
  std::span<const std::int64_t> rows_of(std::int64_t s) const { return rows.subspan(first_row[s], n_rows(s)); }
  std::span<const std::int64_t> rows_below(std::int64_t s) const { return rows_of(s).subspan(n_columns(s)); }
};

/// One thread at a time may use it; the tasks of one call are shared.
class SupernodalPass {
 public:
  /// @param supernodes  what it refers to must outlive the object. Cost: a few passes over the rows
  explicit SupernodalPass(const Supernodes& supernodes);
  ~SupernodalPass();

  /// y = L^-1 P b as tasks, for one or more vectors at once, for all of which the factor is read once. Valid until the
  /// next call. The arrays must not overlap. @param factor  entries of L
  TaskList& forward(const double* factor, std::span<const std::span<const double>> b,
                    std::span<const std::span<double>> y);
  /// x = P^T L^-T y
  TaskList& backward(const double* factor, std::span<const std::span<const double>> y,
                     std::span<const std::span<double>> x);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace creepcontact::linalg
