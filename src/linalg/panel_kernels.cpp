#include "panel_kernels.hpp"

#include <array>
#include <cstddef>
#include <cstring>

#include "creepcontact/base/instruction_sets.hpp"
#include "lapack.hpp"

namespace creepcontact::linalg {

namespace {

template <std::size_t width>
struct Vectors;
template <>
struct Vectors<4> {
  using Double = double __attribute__((vector_size(4 * sizeof(double))));
};
template <>
struct Vectors<8> {
  using Double = double __attribute__((vector_size(8 * sizeof(double))));
};
template <std::size_t width>
using Vector = typename Vectors<width>::Double;

template <std::size_t width>
CREEPCONTACT_INLINE void load(const double* from, Vector<width>& vector) {
  std::memcpy(&vector, from, sizeof vector);
}

/// Columns up to this length are prefetched: the next eight are brought into the cache while these are used. In longer
/// ones the processor itself fetches what follows, better than a program can.
constexpr std::int64_t short_column = 640;

/// to -= L from for `width` rows of `columns` columns.
template <std::size_t width, std::size_t columns, bool fetch>
CREEPCONTACT_INLINE void subtract_rows(const double* first, std::int64_t stride, const double* from, double* to) {
  Vector<width> sum, entries;
  load<width>(to, sum);
#pragma GCC unroll 8
  for (std::size_t k = 0; k < columns; ++k) {
    const double* const column = first + k * stride;
    if (fetch) __builtin_prefetch(column + columns * stride);
    load<width>(column, entries);
    sum -= entries * from[k];
  }
  std::memcpy(to, &sum, sizeof sum);
}

/// to -= L from, for `columns` columns.
template <std::size_t columns, bool fetch = false>
CREEPCONTACT_INLINE void subtract_columns(const double* first, std::int64_t stride, std::int64_t n_rows,
                                          const double* from, double* to) {
  std::int64_t row = 0;
  for (; row + 8 <= n_rows; row += 8) subtract_rows<8, columns, fetch>(first + row, stride, from, to + row);
  if (row + 4 <= n_rows) {
    subtract_rows<4, columns, fetch>(first + row, stride, from, to + row);
    row += 4;
  }
  for (; row < n_rows; ++row) {
    double sum = to[row];
#pragma GCC unroll 8
    for (std::size_t k = 0; k < columns; ++k) sum -= first[k * stride + row] * from[k];
    to[row] = sum;
  }
}

/// to -= L^T from, for `columns` columns.
template <std::size_t columns, bool fetch = false>
CREEPCONTACT_INLINE void subtract_dot_products(const double* first, std::int64_t stride, std::int64_t n_rows,
                                               const double* from, double* to) {
  std::array<Vector<8>, columns> sums{};
  std::int64_t row = 0;
  for (; row + 8 <= n_rows; row += 8) {
    Vector<8> right, entries;
    load<8>(from + row, right);
#pragma GCC unroll 8
    for (std::size_t k = 0; k < columns; ++k) {
      const double* const column = first + k * stride + row;
      if (fetch) __builtin_prefetch(column - 8 * stride);
      load<8>(column, entries);
      sums[k] += entries * right;
    }
  }
  std::array<Vector<4>, columns> halves;
#pragma GCC unroll 8
  for (std::size_t k = 0; k < columns; ++k)
    halves[k] =
        __builtin_shufflevector(sums[k], sums[k], 0, 1, 2, 3) + __builtin_shufflevector(sums[k], sums[k], 4, 5, 6, 7);
  if (row + 4 <= n_rows) {
    Vector<4> right, entries;
    load<4>(from + row, right);
#pragma GCC unroll 8
    for (std::size_t k = 0; k < columns; ++k) {
      load<4>(first + k * stride + row, entries);
      halves[k] += entries * right;
    }
    row += 4;
  }
#pragma GCC unroll 8
  for (std::size_t k = 0; k < columns; ++k) {
    double sum = (halves[k][0] + halves[k][2]) + (halves[k][1] + halves[k][3]);
    for (std::int64_t i = row; i < n_rows; ++i) sum += first[k * stride + i] * from[i];
    to[k] -= sum;
  }
}

/// operation.operator()<columns>(first column) for strips of eight columns and what is left of them.
template <typename Operation>
CREEPCONTACT_INLINE void for_each_strip(std::int64_t n_columns, const Operation& operation) {
  std::int64_t column = 0;
  for (; column + 8 <= n_columns; column += 8) operation.template operator()<8>(column);
  if (n_columns - column >= 4) {
    operation.template operator()<4>(column);
    column += 4;
  }
  if (n_columns - column >= 2) {
    operation.template operator()<2>(column);
    column += 2;
  }
  if (n_columns > column) operation.template operator()<1>(column);
}
/// for_each_strip() from the last strip to the first.
template <typename Operation>
CREEPCONTACT_INLINE void for_each_strip_backwards(std::int64_t n_columns, const Operation& operation) {
  std::int64_t end = n_columns;
  if (end % 2 == 1) operation.template operator()<1>(end -= 1);
  if (end % 4 == 2) operation.template operator()<2>(end -= 2);
  if (end % 8 == 4) operation.template operator()<4>(end -= 4);
  while (end > 0) operation.template operator()<8>(end -= 8);
}

/// The reciprocals of a diagonal: divisions that do not wait for each other.
template <std::size_t columns>
CREEPCONTACT_INLINE std::array<double, columns> reciprocals(const double* corner, std::int64_t stride) {
  std::array<double, columns> result;
#pragma GCC unroll 8
  for (std::size_t k = 0; k < columns; ++k) result[k] = 1 / corner[k * (stride + 1)];
  return result;
}

/// x1 = L11^-1 x1, then x2 -= L21 x1, for `columns` columns. @param corner  the first entry of L11
template <std::size_t columns>
CREEPCONTACT_INLINE void eliminate_columns(const double* corner, std::int64_t stride, std::int64_t n_rows, double* x) {
  const std::array<double, columns> inverse = reciprocals<columns>(corner, stride);
#pragma GCC unroll 8
  for (std::size_t k = 0; k < columns; ++k) {
    x[k] *= inverse[k];
#pragma GCC unroll 8
    for (std::size_t i = k + 1; i < columns; ++i) x[i] -= corner[k * stride + i] * x[k];
  }
  const std::int64_t below = n_rows - static_cast<std::int64_t>(columns);
  if (n_rows <= short_column)
    subtract_columns<columns, true>(corner + columns, stride, below, x, x + columns);
  else
    subtract_columns<columns>(corner + columns, stride, below, x, x + columns);
}

/// x1 = L11^-T (x1 - L21^T x2), for `columns` columns.
template <std::size_t columns>
CREEPCONTACT_INLINE void substitute_columns(const double* corner, std::int64_t stride, std::int64_t n_rows, double* x) {
  const std::array<double, columns> inverse = reciprocals<columns>(corner, stride);
  const std::int64_t below = n_rows - static_cast<std::int64_t>(columns);
  if (n_rows <= short_column)
    subtract_dot_products<columns, true>(corner + columns, stride, below, x + columns, x);
  else
    subtract_dot_products<columns>(corner + columns, stride, below, x + columns, x);
#pragma GCC unroll 8
  for (std::size_t up = 1; up <= columns; ++up) {
    const std::size_t k = columns - up;
#pragma GCC unroll 8
    for (std::size_t i = k + 1; i < columns; ++i) x[k] -= corner[k * stride + i] * x[i];
    x[k] *= inverse[k];
  }
}

constexpr std::int64_t chunk = 4096;  // rows whose part of the vector stays in the innermost cache

CREEPCONTACT_BEST_INSTRUCTIONS void eliminate_one(const Panel& panel, double* x) {
  for_each_strip(
      panel.n_columns, [&]<std::size_t columns>(std::int64_t column) __attribute__((always_inline)) {
        eliminate_columns<columns>(panel.entries + column * (panel.stride + 1), panel.stride, panel.n_rows - column,
                                   x + column);
      });
}

CREEPCONTACT_BEST_INSTRUCTIONS void substitute_one(const Panel& panel, double* x) {
  for_each_strip_backwards(
      panel.n_columns, [&]<std::size_t columns>(std::int64_t column) __attribute__((always_inline)) {
        substitute_columns<columns>(panel.entries + column * (panel.stride + 1), panel.stride, panel.n_rows - column,
                                    x + column);
      });
}

CREEPCONTACT_BEST_INSTRUCTIONS void subtract_product_of_one(const Panel& panel, const double* from, double* to) {
  for (std::int64_t row = 0; row < panel.n_rows; row += chunk) {
    const std::int64_t n_rows = panel.n_rows - row < chunk ? panel.n_rows - row : chunk;
    for_each_strip(
        panel.n_columns, [&]<std::size_t columns>(std::int64_t column) __attribute__((always_inline)) {
          subtract_columns<columns>(panel.entries + column * panel.stride + row, panel.stride, n_rows, from + column,
                                    to + row);
        });
  }
}

CREEPCONTACT_BEST_INSTRUCTIONS void subtract_transposed_product_of_one(const Panel& panel, const double* from,
                                                                       double* to) {
  for_each_strip(
      panel.n_columns, [&]<std::size_t columns>(std::int64_t column) __attribute__((always_inline)) {
        subtract_dot_products<columns>(panel.entries + column * panel.stride, panel.stride, panel.n_rows, from,
                                       to + column);
      });
}

// Rows of several vectors, one after the other, are the columns of the transposed matrix.

/// columns -= rows panel, or its transpose. @param n, k  columns of the result and of the factor at its left
void subtract_blas(char transposed, const Panel& panel, std::int64_t n, std::int64_t k, const double* from, double* to,
                   std::size_t vectors) {
  if (n == 0 || k == 0) return;
  const int m = static_cast<int>(vectors), columns = static_cast<int>(n), inner = static_cast<int>(k),
            stride = static_cast<int>(panel.stride);
  const double minus = -1, one = 1;
  dgemm_("N", &transposed, &m, &columns, &inner, &minus, from, &m, panel.entries, &stride, &one, to, &m, 1, 1);
}

/// With the triangle of a panel. @param transposed  'T': x1 = L11^-1 x1, 'N': x1 = L11^-T x1
void solve_blas(char transposed, const Panel& panel, double* x, std::size_t vectors) {
  const int m = static_cast<int>(vectors), n = static_cast<int>(panel.n_columns),
            stride = static_cast<int>(panel.stride);
  const double one = 1;
  dtrsm_("R", "L", &transposed, "N", &m, &n, &one, panel.entries, &stride, x, &m, 1, 1, 1, 1);
}

/// The rows of a panel below its triangle.
Panel below(const Panel& panel) {
  return {panel.entries + panel.n_columns, panel.stride, panel.n_rows - panel.n_columns, panel.n_columns};
}

}  // namespace

void eliminate(const Panel& panel, double* x, std::size_t vectors) {
  if (vectors == 1) return eliminate_one(panel, x);
  solve_blas('T', panel, x, vectors);
  subtract_product(below(panel), x, x + panel.n_columns * static_cast<std::int64_t>(vectors), vectors);
}

void substitute(const Panel& panel, double* x, std::size_t vectors) {
  if (vectors == 1) return substitute_one(panel, x);
  subtract_transposed_product(below(panel), x + panel.n_columns * static_cast<std::int64_t>(vectors), x, vectors);
  solve_blas('N', panel, x, vectors);
}

void subtract_product(const Panel& panel, const double* from, double* to, std::size_t vectors) {
  if (vectors == 1) return subtract_product_of_one(panel, from, to);
  subtract_blas('T', panel, panel.n_rows, panel.n_columns, from, to, vectors);
}

void subtract_transposed_product(const Panel& panel, const double* from, double* to, std::size_t vectors) {
  if (vectors == 1) return subtract_transposed_product_of_one(panel, from, to);
  subtract_blas('N', panel, panel.n_columns, panel.n_rows, from, to, vectors);
}

}  // namespace creepcontact::linalg
