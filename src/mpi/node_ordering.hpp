#pragma once
/// Order in which the unknowns of a matrix spread over all processes are eliminated.

#include <cstdint>
#include <span>
#include <vector>

#include "creepcontact/linalg/stiffness_solver.hpp"

namespace creepcontact::mpi {

/// Nested dissection by METIS of the graph of the blocks; the trailing unknowns come last, in their order. Collective.
/// @param lower  the part of this process @param block_of, trailing  see StiffnessToAnalyze; the same on all
/// @returns  on process 0: unknowns in the order of their elimination; empty on the others
std::vector<std::int64_t> elimination_order(const linalg::SparseMatrix& lower, std::span<const std::int64_t> block_of,
                                            std::span<const std::int64_t> trailing);

}  // namespace creepcontact::mpi
