#pragma once
/// Whole vectors of the state or of stress, on all threads. Results do not depend on the number of threads.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "creepcontact/numerics/parallel.hpp"

namespace creepcontact::numerics {

/// Calls operation(begin, end) for pieces of 0 .. n.
template <typename Operation>
void for_each_piece(std::size_t n, const Operation& operation) {
  constexpr std::size_t piece = 4096;
#pragma omp parallel for schedule(static) if (n >= parallel_entries)
  for (std::size_t begin = 0; begin < n; begin += piece) operation(begin, std::min(n, begin + piece));
}

inline void copy(std::span<const double> from, std::vector<double>& into) {
  into.resize(from.size());
  for_each_piece(from.size(), [&](std::size_t begin, std::size_t end) {
    std::copy(from.begin() + begin, from.begin() + end, into.begin() + begin);
  });
}

inline bool equal(std::span<const double> a, std::span<const double> b) {
  if (a.size() != b.size()) return false;
  std::atomic<bool> same{true};
  for_each_piece(a.size(), [&](std::size_t begin, std::size_t end) {
    if (!same.load(std::memory_order_relaxed)) return;
    if (!std::equal(a.begin() + begin, a.begin() + end, b.begin() + begin)) same = false;
  });
  return same;
}

/// False if an entry is infinite or not a number, or if the sum of some thousand entries overflows.
inline bool is_finite(std::span<const double> values) {
  std::atomic<bool> finite{true};
  for_each_piece(values.size(), [&](std::size_t begin, std::size_t end) {
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t i = begin; i < end; ++i) sum += values[i];
    if (!std::isfinite(sum)) finite = false;
  });
  return finite;
}

}  // namespace creepcontact::numerics
