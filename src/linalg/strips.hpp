#pragma once
/// What the kernels of one vector and of several have in common: vectors of the processor, strips of columns.

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "creepcontact/base/instruction_sets.hpp"

namespace creepcontact::linalg {

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

}  // namespace creepcontact::linalg
