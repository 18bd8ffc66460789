#include "kernels_of_several.hpp"

#include <algorithm>

#include "strips.hpp"

namespace creepcontact::linalg {

namespace {

/// Part of a row: `pieces` times `width` of its vectors.
template <std::size_t pieces, std::size_t width>
struct Part {
  Vector<width> piece[pieces];

  CREEPCONTACT_INLINE void load(const double* row) {
#pragma GCC unroll 2
    for (std::size_t i = 0; i < pieces; ++i) linalg::load<width>(row + i * width, piece[i]);
  }
  CREEPCONTACT_INLINE void store(double* row) const {
#pragma GCC unroll 2
    for (std::size_t i = 0; i < pieces; ++i) std::memcpy(row + i * width, &piece[i], sizeof piece[i]);
  }
  CREEPCONTACT_INLINE void subtract(double factor, const Part& other) {
#pragma GCC unroll 2
    for (std::size_t i = 0; i < pieces; ++i) piece[i] -= other.piece[i] * factor;
  }
  CREEPCONTACT_INLINE void add(double factor, const Part& other) {
#pragma GCC unroll 2
    for (std::size_t i = 0; i < pieces; ++i) piece[i] += other.piece[i] * factor;
  }
  CREEPCONTACT_INLINE void subtract(const Part& other) {
#pragma GCC unroll 2
    for (std::size_t i = 0; i < pieces; ++i) piece[i] -= other.piece[i];
  }
  CREEPCONTACT_INLINE void multiply(double factor) {
#pragma GCC unroll 2
    for (std::size_t i = 0; i < pieces; ++i) piece[i] *= factor;
  }
};

/// operation.operator()<Part>(first vector) for sixteen vectors at a time, and what is left of them.
template <typename Operation>
CREEPCONTACT_INLINE void for_each_part(std::size_t vectors, const Operation& operation) {
  std::size_t v = 0;
  for (; v + 16 <= vectors; v += 16) operation.template operator()<Part<2, 8>>(v);
  if (v + 8 <= vectors) {
    operation.template operator()<Part<1, 8>>(v);
    v += 8;
  }
  if (v < vectors) operation.template operator()<Part<1, 4>>(v);
}

/// to -= L from for `rows` rows, whose parts are the columns of registers.
template <typename P, std::size_t rows, std::size_t columns>
CREEPCONTACT_INLINE void subtract_rows(const double* first, std::int64_t stride, const std::array<P, columns>& from,
                                       double* to, std::size_t vectors) {
  std::array<P, rows> sums;
#pragma GCC unroll 4
  for (std::size_t i = 0; i < rows; ++i) sums[i].load(to + i * vectors);
#pragma GCC unroll 8
  for (std::size_t k = 0; k < columns; ++k) {
    const double* const column = first + k * stride;
    __builtin_prefetch(column + columns * stride);  // of the next strip
#pragma GCC unroll 4
    for (std::size_t i = 0; i < rows; ++i) sums[i].subtract(column[i], from[k]);
  }
#pragma GCC unroll 4
  for (std::size_t i = 0; i < rows; ++i) sums[i].store(to + i * vectors);
}

/// to -= L from, for `columns` columns.
template <typename P, std::size_t columns>
CREEPCONTACT_INLINE void subtract_columns(const double* first, std::int64_t stride, std::int64_t n_rows,
                                          const std::array<P, columns>& from, double* to, std::size_t vectors) {
  std::int64_t row = 0;
  for (; row + 4 <= n_rows; row += 4) subtract_rows<P, 4>(first + row, stride, from, to + row * vectors, vectors);
  for (; row < n_rows; ++row) subtract_rows<P, 1>(first + row, stride, from, to + row * vectors, vectors);
}

/// to -= L^T from, for `columns` columns.
template <typename P, std::size_t columns>
CREEPCONTACT_INLINE void subtract_dot_products(const double* first, std::int64_t stride, std::int64_t n_rows,
                                               const double* from, std::array<P, columns>& to, std::size_t vectors) {
  std::array<P, columns> sums{};
  for (std::int64_t row = 0; row < n_rows; ++row) {
    P right;
    right.load(from + row * vectors);
#pragma GCC unroll 8
    for (std::size_t k = 0; k < columns; ++k) {
      const double* const entry = first + k * stride + row;
      if (row % 8 == 0) __builtin_prefetch(entry - columns * stride);
      sums[k].add(*entry, right);
    }
  }
#pragma GCC unroll 8
  for (std::size_t k = 0; k < columns; ++k) to[k].subtract(sums[k]);
}

template <typename P, std::size_t columns>
CREEPCONTACT_INLINE void load_rows(const double* x, std::size_t vectors, std::array<P, columns>& rows) {
#pragma GCC unroll 8
  for (std::size_t k = 0; k < columns; ++k) rows[k].load(x + k * vectors);
}
template <typename P, std::size_t columns>
CREEPCONTACT_INLINE void store_rows(const std::array<P, columns>& rows, double* x, std::size_t vectors) {
#pragma GCC unroll 8
  for (std::size_t k = 0; k < columns; ++k) rows[k].store(x + k * vectors);
}

/// x1 = L11^-1 x1, then x2 -= L21 x1, for `columns` columns. @param corner  the first entry of L11
template <typename P, std::size_t columns>
CREEPCONTACT_INLINE void eliminate_columns(const double* corner, std::int64_t stride, std::int64_t n_rows, double* x,
                                           std::size_t vectors) {
  const std::array<double, columns> inverse = reciprocals<columns>(corner, stride);
  std::array<P, columns> own;
  load_rows(x, vectors, own);
#pragma GCC unroll 8
  for (std::size_t k = 0; k < columns; ++k) {
    own[k].multiply(inverse[k]);
#pragma GCC unroll 8
    for (std::size_t i = k + 1; i < columns; ++i) own[i].subtract(corner[k * stride + i], own[k]);
  }
  store_rows(own, x, vectors);
  subtract_columns(corner + columns, stride, n_rows - static_cast<std::int64_t>(columns), own, x + columns * vectors,
                   vectors);
}

/// x1 = L11^-T (x1 - L21^T x2), for `columns` columns.
template <typename P, std::size_t columns>
CREEPCONTACT_INLINE void substitute_columns(const double* corner, std::int64_t stride, std::int64_t n_rows, double* x,
                                            std::size_t vectors) {
  const std::array<double, columns> inverse = reciprocals<columns>(corner, stride);
  std::array<P, columns> own;
  load_rows(x, vectors, own);
  subtract_dot_products(corner + columns, stride, n_rows - static_cast<std::int64_t>(columns), x + columns * vectors,
                        own, vectors);
#pragma GCC unroll 8
  for (std::size_t up = 1; up <= columns; ++up) {
    const std::size_t k = columns - up;
#pragma GCC unroll 8
    for (std::size_t i = k + 1; i < columns; ++i) own[k].subtract(corner[k * stride + i], own[i]);
    own[k].multiply(inverse[k]);
  }
  store_rows(own, x, vectors);
}

constexpr std::int64_t rows_in_cache = 128;  // of sixteen vectors

/// The rows of a panel below its triangle.
Panel below(const Panel& panel) {
  return {panel.entries + panel.n_columns, panel.stride, panel.n_rows - panel.n_columns, panel.n_columns};
}

CREEPCONTACT_BEST_INSTRUCTIONS void solve_triangle(const Panel& panel, double* x, std::size_t vectors) {
  for_each_strip(
      panel.n_columns, [&]<std::size_t columns>(std::int64_t column) __attribute__((always_inline)) {
        for_each_part(
            vectors, [&]<typename P>(std::size_t v) __attribute__((always_inline)) {
              eliminate_columns<P, columns>(panel.entries + column * (panel.stride + 1), panel.stride,
                                            panel.n_columns - column, x + column * vectors + v, vectors);
            });
      });
}

CREEPCONTACT_BEST_INSTRUCTIONS void solve_transposed_triangle(const Panel& panel, double* x, std::size_t vectors) {
  for_each_strip_backwards(
      panel.n_columns, [&]<std::size_t columns>(std::int64_t column) __attribute__((always_inline)) {
        for_each_part(
            vectors, [&]<typename P>(std::size_t v) __attribute__((always_inline)) {
              substitute_columns<P, columns>(panel.entries + column * (panel.stride + 1), panel.stride,
                                             panel.n_columns - column, x + column * vectors + v, vectors);
            });
      });
}

}  // namespace

CREEPCONTACT_BEST_INSTRUCTIONS void subtract_product_of_several(const Panel& panel, const double* from, double* to,
                                                                std::size_t vectors) {
  for (std::int64_t row = 0; row < panel.n_rows; row += rows_in_cache) {
    const std::int64_t n_rows = std::min(panel.n_rows - row, rows_in_cache);
    for_each_strip(
        panel.n_columns, [&]<std::size_t columns>(std::int64_t column) __attribute__((always_inline)) {
          for_each_part(
              vectors, [&]<typename P>(std::size_t v) __attribute__((always_inline)) {
                std::array<P, columns> right;
                load_rows(from + column * vectors + v, vectors, right);
                subtract_columns(panel.entries + column * panel.stride + row, panel.stride, n_rows, right,
                                 to + row * vectors + v, vectors);
              });
        });
  }
}

CREEPCONTACT_BEST_INSTRUCTIONS void subtract_transposed_product_of_several(const Panel& panel, const double* from,
                                                                           double* to, std::size_t vectors) {
  for (std::int64_t row = 0; row < panel.n_rows; row += rows_in_cache) {
    const std::int64_t n_rows = std::min(panel.n_rows - row, rows_in_cache);
    for_each_strip_backwards(
        panel.n_columns, [&]<std::size_t columns>(std::int64_t column) __attribute__((always_inline)) {
          for_each_part(
              vectors, [&]<typename P>(std::size_t v) __attribute__((always_inline)) {
                std::array<P, columns> left;
                load_rows(to + column * vectors + v, vectors, left);
                subtract_dot_products(panel.entries + column * panel.stride + row, panel.stride, n_rows,
                                      from + row * vectors + v, left, vectors);
                store_rows(left, to + column * vectors + v, vectors);
              });
        });
  }
}

void eliminate_several(const Panel& panel, double* x, std::size_t vectors) {
  solve_triangle(panel, x, vectors);
  subtract_product_of_several(below(panel), x, x + panel.n_columns * vectors, vectors);
}

void substitute_several(const Panel& panel, double* x, std::size_t vectors) {
  subtract_transposed_product_of_several(below(panel), x + panel.n_columns * vectors, x, vectors);
  solve_transposed_triangle(panel, x, vectors);
}

}  // namespace creepcontact::linalg
