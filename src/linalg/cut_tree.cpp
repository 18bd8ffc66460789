#include "cut_tree.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace creepcontact::linalg {

namespace {

/// Subtrees of at most this part of all entries are single tasks: small enough for some ten threads.
constexpr double largest_part = 1.0 / 48;
/// Smaller factors stay in the cache and are not cut.
constexpr double min_cut = 1 << 17;  // entries
constexpr std::int64_t panel_width = 128;

/// Positions of some rows among others; both ascend.
std::vector<std::int32_t> positions(std::span<const std::int64_t> rows, std::span<const std::int64_t> among) {
  std::vector<std::int32_t> result;
  result.reserve(rows.size());
  std::size_t i = 0;
  for (const std::int64_t row : rows) {
    while (i < among.size() && among[i] < row) ++i;
    if (i == among.size() || among[i] != row) throw std::logic_error("a row of a supernode is missing in its parent");
    result.push_back(static_cast<std::int32_t>(i));
  }
  return result;
}

}  // namespace

/// The elimination tree of the supernodes.
struct CutTree::Tree {
  explicit Tree(const Supernodes& nodes) : parent(nodes.size(), -1), first(nodes.size()), entries(nodes.size(), 0.0) {
    std::vector<std::int64_t> supernode_of(nodes.first_column.empty() ? 0 : nodes.first_column.back());
    for (std::int64_t s = 0; s < nodes.size(); ++s)
      std::fill(supernode_of.begin() + nodes.first_column[s], supernode_of.begin() + nodes.first_column[s + 1], s);
    std::iota(first.begin(), first.end(), 0);
    for (std::int64_t s = 0; s < nodes.size(); ++s) {
      entries[s] += static_cast<double>(nodes.n_rows(s)) * static_cast<double>(nodes.n_columns(s));
      if (nodes.n_below(s) == 0) continue;
      const std::int64_t p = supernode_of[nodes.rows_below(s).front()];
      if (p <= s) throw std::logic_error("the supernodes are not postordered");
      parent[s] = p;
      first[p] = std::min(first[p], first[s]);
      entries[p] += entries[s];
    }
  }

  std::vector<std::int64_t> parent;  // -1: none
  std::vector<std::int64_t> first;   // the subtree of s is first[s] .. s
  std::vector<double> entries;       // of the subtree
};

CutTree::CutTree(const Supernodes& supernodes) : nodes(supernodes) {
  const Tree tree(nodes);
  cut(tree);
  place_children();
  list_tasks(tree);
}

void CutTree::cut(const Tree& tree) {
  double all = 0;
  for (std::int64_t s = 0; s < nodes.size(); ++s)
    if (tree.parent[s] < 0) all += tree.entries[s];
  const double most = std::max(largest_part * all, min_cut);
  std::vector<Index> branch_of(nodes.size(), -1);
  std::vector<std::int64_t> depth(nodes.size(), 0);
  for (std::int64_t s = nodes.size() - 1; s >= 0; --s) {  // parents first
    const std::int64_t p = tree.parent[s];
    const bool below_a_subtree = p >= 0 && (branch_of[p] < 0 || front_of[branch_of[p]] < 0);
    if (below_a_subtree) continue;
    branch_of[s] = std::ssize(branches);
    branches.push_back(std::make_unique<Branch>());
    branches.back()->root = s;
    branches.back()->parent = p < 0 ? -1 : branch_of[p];
    if (p >= 0) fronts[front_of[branch_of[p]]]->children.push_back(branches.size() - 1);
    if (tree.entries[s] <= most) {
      front_of.push_back(-1);
      subtree_of.push_back(std::ssize(subtrees));
      subtrees.emplace_back();
      subtrees.back().branch = branches.size() - 1;
      subtrees.back().first = tree.first[s];
      continue;
    }
    front_of.push_back(std::ssize(fronts));
    subtree_of.push_back(-1);
    fronts.push_back(std::make_unique<Front>());
    Front& front = *fronts.back();
    front.branch = branches.size() - 1;
    depth[s] = p < 0 ? 0 : depth[p] + 1;
    front.depth = depth[s];
    const std::int64_t n = nodes.n_columns(s), n_panels = (n + panel_width - 1) / panel_width;
    front.panels = std::vector<Column>(n_panels);
    for (std::int64_t k = 0; k < n_panels; ++k) {
      Column& panel = front.panels[k];
      panel.begin = n * k / n_panels;
      panel.end = n * (k + 1) / n_panels;
    }
  }
}

void CutTree::place_children() {
  for (const auto& branch : branches)
    if (branch->parent >= 0)
      branch->in_front = positions(nodes.rows_below(branch->root), nodes.rows_of(branches[branch->parent]->root));
  for (Subtree& subtree : subtrees) {
    const std::int64_t root = branches[subtree.branch]->root;
    const std::span<const std::int64_t> below = nodes.rows_below(root);
    for (std::int64_t s = subtree.first; s <= root; ++s) {
      subtree.most_rows = std::max(subtree.most_rows, nodes.n_rows(s));
      const std::span<const std::int64_t> rows = nodes.rows_below(s);
      const auto outside = std::ranges::lower_bound(rows, nodes.first_column[root + 1]);
      const std::vector<std::int32_t> at = positions({outside, rows.end()}, below);
      subtree.outside.insert(subtree.outside.end(), at.begin(), at.end());
    }
  }
}

void CutTree::list_tasks(const Tree& tree) {
  for (std::size_t n = subtrees.size(); n-- > 0;) {  // in the order of the factor
    tasks.push_back({&subtrees[n], nullptr, 0});
    work.push_back(tree.entries[branches[subtrees[n].branch]->root]);
  }
  // Fronts of the same depth do not need each other: panel by panel in turn.
  std::vector<Task> of_fronts;
  for (const auto& front : fronts)
    for (std::size_t p = 0; p < front->panels.size(); ++p) of_fronts.push_back({nullptr, front.get(), p});
  std::ranges::stable_sort(of_fronts, [](const Task& a, const Task& b) {
    return std::pair(-a.front->depth, a.panel) < std::pair(-b.front->depth, b.panel);
  });
  for (const Task& task : of_fronts) {
    tasks.push_back(task);
    const Column& panel = task.front->panels[task.panel];
    work.push_back(static_cast<double>(panel.end - panel.begin) *
                   static_cast<double>(nodes.n_rows(branches[task.front->branch]->root) - panel.begin));
  }
}

}  // namespace creepcontact::linalg
