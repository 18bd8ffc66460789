#pragma once
/// Elimination order: nested dissection of the block graph, then the trailing unknowns.

#include <vector>

#include "cholmod_context.hpp"

namespace creepcontact::linalg {

/// Unknowns in the order of their elimination: METIS nested dissection of the graph whose vertices are the blocks,
/// unknowns of a block one after the other; the trailing ones last, in their own order.
std::vector<std::int64_t> elimination_order(const SparseMatrix& lower, std::span<const std::int64_t> block_of,
                                            std::span<const std::int64_t> trailing, CholmodContext& context);

/// Entries missing in the pattern to make every postordering of the elimination tree leave the trailing unknowns where
/// they are: last, in their order. That is so if they form a path in the tree and all else lies below its first one.
/// Nearly always there are none; unknowns that are not connected but through the trailing ones, or trailing ones not
/// connected at all, need some. Lower triangle, caller's numbering, zeros to be added to the pattern.
/// @param order  of elimination_order()
SparseMatrix missing_links(const SparseMatrix& lower, const std::vector<std::int64_t>& order, std::size_t n_trailing,
                           CholmodContext& context);

}  // namespace creepcontact::linalg
