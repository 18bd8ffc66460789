#pragma once
/// Which loops are shared out among the OpenMP threads. A module that loops so is compiled with OpenMP.

#include <cstddef>

namespace creepcontact::numerics {

// Shorter loops are faster on one thread: waking the others costs more than the work. By what a turn works on:
inline constexpr std::size_t parallel_entries = 20000;  ///< an entry of the state
inline constexpr std::size_t parallel_points = 2000;    ///< the stress or creep rate at an integration point
inline constexpr std::size_t parallel_tangents = 500;   ///< the derivative of the creep rate there
inline constexpr std::size_t parallel_elements = 128;   ///< an element or a node with its neighbours

/// operation(i) for i = 0 .. n-1, in no particular order; on all threads from n = parallel_from.
template <typename Operation>
void for_each_index(std::size_t n, std::size_t parallel_from, const Operation& operation) {
#pragma omp parallel for schedule(static) if (n >= parallel_from)
  for (std::size_t i = 0; i < n; ++i) operation(i);
}

}  // namespace creepcontact::numerics
