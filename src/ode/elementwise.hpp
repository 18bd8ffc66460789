#pragma once
/// Loops over the state, shared out among the OpenMP threads where it is long enough to pay.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace creepcontact::ode {

/// Shorter vectors are faster on one thread: waking the others costs more than the arithmetic.
inline constexpr std::size_t parallel_threshold = 20000;

/// operation(i) for i = 0 .. n-1, in no particular order.
template <typename Operation>
void for_each_index(std::size_t n, Operation operation) {
#pragma omp parallel for simd schedule(static) if (parallel : n >= parallel_threshold)
  for (std::size_t i = 0; i < n; ++i) operation(i);
}

/// Sum of term(i) for i = 0 .. n-1.
template <typename Term>
double sum_over(std::size_t n, Term term) {
  double sum = 0;
#pragma omp parallel for simd schedule(static) reduction(+ : sum) if (parallel : n >= parallel_threshold)
  for (std::size_t i = 0; i < n; ++i) sum += term(i);
  return sum;
}

/// max |a_i - b_i|; NaN or infinity if any difference is not finite.
inline double max_difference(std::span<const double> a, std::span<const double> b) {
  double largest = 0;
  double tainted = 0;  // 0 * x is NaN for x infinite or NaN, which a maximum alone would pass over
#pragma omp parallel for simd schedule(static) reduction(max : largest) \
    reduction(+ : tainted) if (parallel : a.size() >= parallel_threshold)
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = std::abs(a[i] - b[i]);
    largest = std::max(largest, difference);
    tainted += 0.0 * difference;
  }
  return largest + tainted;
}

}  // namespace creepcontact::ode
