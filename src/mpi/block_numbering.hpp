#pragma once
/// Rows of a distributed matrix: each process owns a range of nodes, and every node has three rows.

#include <cstdint>
#include <span>
#include <vector>

#include "creepcontact/linalg/stiffness_solver.hpp"

namespace creepcontact::mpi {

constexpr int block_size = 3;

struct BlockNumbering {
  std::vector<std::int64_t> row_of;  ///< of every unknown
  std::vector<std::int64_t>
      own_padding;  ///< rows of this process without an unknown: their nodes have fewer than three
  std::int64_t n_own_blocks = 0;
};

/// Gives every node to the first process that has entries for it. Collective.
/// @param lower  the part of this process @param block_of  see StiffnessToAnalyze; the same on all
BlockNumbering number_blocks(const linalg::SparseMatrix& lower, std::span<const std::int64_t> block_of);

}  // namespace creepcontact::mpi
