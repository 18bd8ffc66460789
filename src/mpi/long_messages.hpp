#pragma once
/// Messages of any length: MPI counts in int.

#include <mpi.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace creepcontact::mpi {

inline constexpr std::size_t longest_message = std::size_t{1} << 27;  // entries

/// operation(part) for consecutive parts of the values that fit into a message.
template <typename Number, typename Operation>
void for_each_message(std::span<Number> values, const Operation& operation) {
  for (std::size_t begin = 0; begin < values.size(); begin += longest_message)
    operation(values.subspan(begin, std::min(longest_message, values.size() - begin)));
}

inline MPI_Datatype datatype(double /*of*/) {
  return MPI_DOUBLE;
}
inline MPI_Datatype datatype(std::int32_t /*of*/) {
  return MPI_INT32_T;
}
inline MPI_Datatype datatype(std::int64_t /*of*/) {
  return MPI_INT64_T;
}

/// On process 0: the values of all processes, concatenated by rank; empty on the others. Collective.
template <typename Number>
std::vector<Number> gather_to_root(std::span<const Number> values) {
  int rank = 0, size = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  const std::int64_t own = std::ssize(values);
  std::vector<std::int64_t> counts(rank == 0 ? size : 0);
  MPI_Gather(&own, 1, MPI_INT64_T, counts.data(), 1, MPI_INT64_T, 0, MPI_COMM_WORLD);
  constexpr int tag = 1;
  if (rank != 0) {
    for_each_message(values, [](std::span<const Number> part) {
      MPI_Send(part.data(), static_cast<int>(part.size()), datatype(Number()), 0, tag, MPI_COMM_WORLD);
    });
    return {};
  }
  std::int64_t total = 0;
  for (const std::int64_t count : counts) total += count;
  std::vector<Number> all(total);
  std::span<Number> rest(all);
  std::ranges::copy(values, rest.begin());
  for (int from = 0; from < size; ++from) {
    const std::span<Number> here = rest.first(counts[from]);
    rest = rest.subspan(counts[from]);
    if (from > 0)
      for_each_message(here, [from](std::span<Number> part) {
        MPI_Recv(part.data(), static_cast<int>(part.size()), datatype(Number()), from, tag, MPI_COMM_WORLD,
                 MPI_STATUS_IGNORE);
      });
  }
  return all;
}

}  // namespace creepcontact::mpi
