#include "node_ordering.hpp"

#include <metis.h>

#include <algorithm>
#include <numeric>

#include "creepcontact/base/error.hpp"
#include "long_messages.hpp"

namespace creepcontact::mpi {
namespace {

/// Blocks numbered from 0 without holes.
std::vector<std::int32_t> numbered(std::span<const std::int64_t> block_of) {
  std::vector<std::int64_t> numbers(block_of.begin(), block_of.end());
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  std::vector<std::int32_t> result;
  result.reserve(block_of.size());
  for (const std::int64_t block : block_of)
    result.push_back(static_cast<std::int32_t>(std::ranges::lower_bound(numbers, block) - numbers.begin()));
  return result;
}

/// Pairs of different blocks that the matrix connects, the larger one first, each pair once.
std::vector<std::int64_t> block_edges(const linalg::SparseMatrix& lower, const std::vector<std::int32_t>& block) {
  std::vector<std::int64_t> edges;
  for (std::int64_t column = 0; column < lower.outerSize(); ++column)
    for (linalg::SparseMatrix::InnerIterator entry(lower, column); entry; ++entry) {
      const std::int64_t a = block[entry.row()], b = block[column];
      if (a != b) edges.push_back(std::max(a, b) << 32 | std::min(a, b));
    }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// The graph in METIS' form, and the order it makes.
std::vector<idx_t> nested_dissection(idx_t n_blocks, const std::vector<std::int64_t>& edges) {
  std::vector<idx_t> start(n_blocks + 1, 0), neighbours(2 * edges.size());
  const auto first = [](std::int64_t edge) { return static_cast<idx_t>(edge >> 32); };
  const auto second = [](std::int64_t edge) { return static_cast<idx_t>(edge & 0xffffffff); };
  for (const std::int64_t edge : edges) {
    ++start[first(edge) + 1];
    ++start[second(edge) + 1];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<idx_t> next(start.begin(), start.end() - 1);
  for (const std::int64_t edge : edges) {
    neighbours[next[first(edge)]++] = second(edge);
    neighbours[next[second(edge)]++] = first(edge);
  }
  std::vector<idx_t> order(n_blocks), position(n_blocks);
  if (edges.empty()) {
    std::iota(order.begin(), order.end(), 0);
    return order;
  }
  if (METIS_NodeND(&n_blocks, start.data(), neighbours.data(), nullptr, nullptr, order.data(), position.data()) !=
      METIS_OK)
    throw SolverError("METIS cannot order the unknowns; probably memory has run out");
  return order;
}

}  // namespace

std::vector<std::int64_t> elimination_order(const linalg::SparseMatrix& lower, std::span<const std::int64_t> block_of,
                                            std::span<const std::int64_t> trailing) {
  const std::vector<std::int32_t> block = numbered(block_of);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  std::vector<std::int64_t> edges = gather_to_root(std::span<const std::int64_t>(block_edges(lower, block)));
  if (rank != 0) return {};
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  const idx_t n_blocks = block.empty() ? 0 : *std::ranges::max_element(block) + 1;
  std::vector<std::vector<std::int64_t>> members(n_blocks);
  for (std::size_t i = 0; i < block.size(); ++i) members[block[i]].push_back(static_cast<std::int64_t>(i));
  std::vector<char> is_trailing(block.size(), 0);
  for (const std::int64_t unknown : trailing) is_trailing[unknown] = 1;
  std::vector<std::int64_t> order;
  order.reserve(block.size());
  for (const idx_t next : nested_dissection(n_blocks, edges))
    for (const std::int64_t unknown : members[next])
      if (!is_trailing[unknown]) order.push_back(unknown);
  order.insert(order.end(), trailing.begin(), trailing.end());
  return order;
}

}  // namespace creepcontact::mpi
