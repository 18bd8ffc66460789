#pragma once
/// For every node the rows (element, local node) of an array over all elements, in ascending order: the sum over them
/// needs neither locks nor colours, and does not depend on the number of threads.

#include <cstdint>
#include <span>
#include <vector>

namespace creepcontact::mechanics {

class NodeEntries {
 public:
  /// @param node_of_entry  node of every row
  NodeEntries(std::size_t n_nodes, std::span<const std::int64_t> node_of_entry)
      : offsets_(n_nodes + 1, 0), entries_(node_of_entry.size()) {
    for (const std::int64_t node : node_of_entry) ++offsets_[node + 1];
    for (std::size_t i = 0; i < n_nodes; ++i) offsets_[i + 1] += offsets_[i];
    std::vector<std::size_t> next(offsets_.begin(), offsets_.end() - 1);
    for (std::size_t entry = 0; entry < node_of_entry.size(); ++entry) entries_[next[node_of_entry[entry]]++] = entry;
  }

  std::span<const std::size_t> of(std::size_t node) const {
    return {entries_.data() + offsets_[node], offsets_[node + 1] - offsets_[node]};
  }
  std::size_t n_entries() const { return entries_.size(); }

 private:
  std::vector<std::size_t> offsets_, entries_;
};

}  // namespace creepcontact::mechanics
