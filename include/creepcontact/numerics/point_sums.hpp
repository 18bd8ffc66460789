#pragma once
/// Sums over integration points.

#include <algorithm>
#include <numeric>
#include <vector>

#include "creepcontact/numerics/parallel.hpp"

namespace creepcontact::numerics {

/// Sum of term(p) for p < n, on all threads. Pieces of fixed size are each summed by one thread, so the result is the
/// same to the last bit for any number of threads.
template <typename Term>
double sum_over_points(std::size_t n, Term term) {
  constexpr std::size_t piece = 1000;
  std::vector<double> sums((n + piece - 1) / piece);
#pragma omp parallel for schedule(static) if (n > parallel_points)
  for (std::size_t i = 0; i < sums.size(); ++i)
    for (std::size_t p = i * piece; p < std::min(n, (i + 1) * piece); ++p) sums[i] += term(p);
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}  // namespace creepcontact::numerics
