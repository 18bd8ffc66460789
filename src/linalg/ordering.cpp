#include "ordering.hpp"

#include <algorithm>
#include <mutex>

#include "creepcontact/base/index.hpp"

namespace creepcontact::linalg {

namespace {

using Indices = std::vector<std::int64_t>;
using Triplet = Eigen::Triplet<double, std::int64_t>;

/// Blocks renumbered from 0 without holes, and the unknowns of each.
struct Blocks {
  explicit Blocks(std::span<const std::int64_t> block_of) : of(block_of.size()) {
    Indices numbers(block_of.begin(), block_of.end());
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    members.resize(numbers.size());
    for (std::size_t i = 0; i < of.size(); ++i) {
      of[i] = std::lower_bound(numbers.begin(), numbers.end(), block_of[i]) - numbers.begin();
      members[of[i]].push_back(i);
    }
  }

  Indices of;                    // block of an unknown
  std::vector<Indices> members;  // unknowns of a block
};

/// Pattern of the blocks, lower triangle.
SparseMatrix block_graph(const SparseMatrix& lower, const Blocks& blocks) {
  const std::int64_t n = blocks.members.size();
  Indices last_seen(blocks.members.size(), -1);
  std::vector<Triplet> edges;
  for (std::int64_t block = 0; block < n; ++block) {
    for (const std::int64_t column : blocks.members[block]) {
      for (SparseMatrix::InnerIterator entry(lower, column); entry; ++entry) {
        const std::int64_t other = blocks.of[entry.row()];
        if (last_seen[other] == block) continue;
        last_seen[other] = block;
        edges.emplace_back(std::max(block, other), std::min(block, other), 1.0);
      }
    }
  }
  SparseMatrix graph(n, n);
  graph.setFromTriplets(edges.begin(), edges.end());
  return graph;
}

}  // namespace

Indices elimination_order(const SparseMatrix& lower, std::span<const std::int64_t> block_of,
                          std::span<const std::int64_t> trailing, CholmodContext& context) {
  const Blocks blocks(block_of);
  const SparseMatrix graph = block_graph(lower, blocks);
  cholmod_sparse graph_view = view(graph);
  Indices block_order(blocks.members.size());
  {
    // METIS draws from rand(), one sequence for the process: two calls at once would change each other's order.
    static std::mutex mutex;
    const std::lock_guard alone(mutex);
    cholmod_l_metis(&graph_view, nullptr, 0, 1, cholmod_integers(block_order.data()), context.get());
  }
  context.check("order");

  std::vector<bool> is_trailing(block_of.size(), false);
  for (const std::int64_t unknown : trailing) is_trailing[unknown] = true;
  Indices order;
  order.reserve(block_of.size());
  for (const std::int64_t block : block_order) {
    for (const std::int64_t unknown : blocks.members[block]) {
      if (!is_trailing[unknown]) order.push_back(unknown);
    }
  }
  order.insert(order.end(), trailing.begin(), trailing.end());
  return order;
}

SparseMatrix missing_links(const SparseMatrix& lower, const Indices& order, std::size_t n_trailing,
                           CholmodContext& context) {
  const Index n = order.size(), first = n - n_trailing;
  SparseMatrix links(lower.rows(), lower.cols());
  if (n_trailing == 0) return links;

  cholmod_sparse matrix = view(lower);
  const SparsePointer upper(cholmod_l_ptranspose(&matrix, 0, cholmod_integers(order.data()), nullptr, 0, context.get()),
                            FreeSparse{context.get()});
  context.check("permute");
  Indices parent(n);
  cholmod_l_etree(upper.get(), cholmod_integers(parent.data()), context.get());
  context.check("analyse");

  std::vector<Triplet> entries;
  const auto link = [&](std::size_t i, std::size_t j) {
    entries.emplace_back(std::max(order[i], order[j]), std::min(order[i], order[j]), 0.0);
  };
  // A leading root that hangs at a later trailing unknown, or at none, goes below the first one.
  for (Index j = 0; j < first; ++j) {
    if (parent[j] < 0 || parent[j] > first) link(first, j);
  }
  const bool moved = !entries.empty();
  for (Index j = first; j + 1 < n; ++j) {
    if (moved || parent[j] < 0 || parent[j] != j + 1) link(j + 1, j);
  }
  links.setFromTriplets(entries.begin(), entries.end());
  return links;
}

}  // namespace creepcontact::linalg
