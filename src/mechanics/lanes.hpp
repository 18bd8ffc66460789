#pragma once
/// Points or nodes of an element side by side in the registers. A loop over points is written once, for any type V of
/// values at adjacent points: Four for four of them, double for one. Everything is inlined into functions that are
/// compiled for several instruction sets.

#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

#include "creepcontact/base/instruction_sets.hpp"

// How vectors are passed depends on the instruction set: no matter, since everything is inlined.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace creepcontact::mechanics {

constexpr std::size_t lanes = 4;
using Four = double __attribute__((vector_size(4 * sizeof(double))));

template <typename V>
CREEPCONTACT_INLINE V load(const double* from) {
  V values;
  std::memcpy(&values, from, sizeof values);
  return values;
}
template <typename V>
CREEPCONTACT_INLINE void store(const V& values, double* to) {
  std::memcpy(to, &values, sizeof values);
}
/// Values of adjacent points that are `stride` numbers apart.
template <typename V>
CREEPCONTACT_INLINE V load(const double* from, std::size_t stride) {
  if constexpr (std::is_same_v<V, double>)
    return *from;
  else
    return V{from[0], from[stride], from[2 * stride], from[3 * stride]};
}
template <typename V>
CREEPCONTACT_INLINE void store(const V& values, double* to, std::size_t stride) {
  if constexpr (std::is_same_v<V, double>)
    *to = values;
  else
    for (std::size_t i = 0; i < 4; ++i) to[i * stride] = values[i];
}

/// work(i) for i < n, each a constant: what arrays have at such places stays in registers.
template <std::size_t n, typename Work>
CREEPCONTACT_INLINE void for_constants(const Work& work) {
  [&]<std::size_t... i>(std::index_sequence<i...>) __attribute__((always_inline)) {
    (work(std::integral_constant<std::size_t, i>()), ...);
  }
  (std::make_index_sequence<n>());
}

/// work.operator()<V>(first point) for all of n points.
template <typename Work>
CREEPCONTACT_INLINE void for_each_lane(std::size_t n, const Work& work) {
  std::size_t p = 0;
  for (; p + 4 <= n; p += 4) work.template operator()<Four>(p);
  for (; p < n; ++p) work.template operator()<double>(p);
}

/// A sum over the points of an element.
class LaneSum {
 public:
  CREEPCONTACT_INLINE void add(const Four& values) { four_ += values; }
  CREEPCONTACT_INLINE void add(const double& value) { one_ += value; }
  CREEPCONTACT_INLINE double value() const { return one_ + ((four_[0] + four_[2]) + (four_[1] + four_[3])); }

 private:
  Four four_{};
  double one_ = 0;
};

}  // namespace creepcontact::mechanics
