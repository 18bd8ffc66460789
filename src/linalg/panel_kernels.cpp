#include "panel_kernels.hpp"

#include <array>
#include <cstddef>
#include <cstring>

#include "creepcontact/base/instruction_sets.hpp"
#include "kernels_of_several.hpp"
#include "strips.hpp"

namespace creepcontact::linalg {

namespace {

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

}  // namespace

void eliminate(const Panel& panel, double* x, std::size_t vectors) {
  vectors == 1 ? eliminate_one(panel, x) : eliminate_several(panel, x, vectors);
}

void substitute(const Panel& panel, double* x, std::size_t vectors) {
  vectors == 1 ? substitute_one(panel, x) : substitute_several(panel, x, vectors);
}

void subtract_product(const Panel& panel, const double* from, double* to, std::size_t vectors) {
  vectors == 1 ? subtract_product_of_one(panel, from, to) : subtract_product_of_several(panel, from, to, vectors);
}

void subtract_transposed_product(const Panel& panel, const double* from, double* to, std::size_t vectors) {
  vectors == 1 ? subtract_transposed_product_of_one(panel, from, to)
               : subtract_transposed_product_of_several(panel, from, to, vectors);
}

}  // namespace creepcontact::linalg
