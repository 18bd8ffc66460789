#pragma once
/// Loops that are shared among the OpenMP threads. A module that uses them must be compiled with OpenMP.

#include <cstddef>

namespace creepcontact::numerics {

// Shorter loops run on one thread, because waking the others costs more than the work. Thresholds by the work per pass:
inline constexpr std::size_t parallel_entries = 20000;  ///< one entry of the state
inline constexpr std::size_t parallel_points = 2000;    ///< stress or creep rate at one integration point
inline constexpr std::size_t parallel_tangents = 500;   ///< derivative of the creep rate at one integration point
inline constexpr std::size_t parallel_elements = 128;   ///< one element, or one node with its neighbours

/// Calls operation(i) for i = 0 .. n-1 in unspecified order; on all threads if n >= parallel_from.
template <typename Operation>
void for_each_index(std::size_t n, std::size_t parallel_from, const Operation& operation) {
#pragma omp parallel for schedule(static) if (n >= parallel_from)
  for (std::size_t i = 0; i < n; ++i) operation(i);
}

}  // namespace creepcontact::numerics
