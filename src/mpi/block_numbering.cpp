#include "block_numbering.hpp"

#include <mpi.h>

#include <algorithm>
#include <numeric>

namespace creepcontact::mpi {

BlockNumbering number_blocks(const linalg::SparseMatrix& lower, std::span<const std::int64_t> block_of) {
  int rank = 0, n_processes = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &n_processes);

  std::vector<std::int64_t> block(block_of.size());
  std::vector<int> used;  // unknowns of every block
  for (std::size_t i = 0; i < block_of.size(); ++i) {
    if (i == 0 || block_of[i] != block_of[i - 1] || used.back() == block_size) used.push_back(0);
    ++used.back();
    block[i] = std::ssize(used) - 1;
  }
  std::vector<int> owner(used.size(), n_processes);
  for (std::int64_t column = 0; column < lower.outerSize(); ++column)
    for (linalg::SparseMatrix::InnerIterator entry(lower, column); entry; ++entry)
      owner[block[entry.row()]] = owner[block[column]] = rank;
  MPI_Allreduce(MPI_IN_PLACE, owner.data(), static_cast<int>(owner.size()), MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  for (int& process : owner) process = std::min(process, n_processes - 1);

  std::vector<std::int64_t> next(n_processes + 1, 0);  // block of each process
  for (const int process : owner) ++next[process + 1];
  BlockNumbering result;
  result.n_own_blocks = next[rank + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<std::int64_t> number(used.size());
  for (std::size_t b = 0; b < used.size(); ++b) {
    number[b] = next[owner[b]]++;
    for (int k = used[b]; k < block_size && owner[b] == rank; ++k)
      result.own_padding.push_back(block_size * number[b] + k);
  }
  for (std::size_t i = 0; i < block.size(); ++i) {
    const bool is_first = i == 0 || block[i] != block[i - 1];
    result.row_of.push_back(is_first ? block_size * number[block[i]] : result.row_of.back() + 1);
  }
  return result;
}

}  // namespace creepcontact::mpi
