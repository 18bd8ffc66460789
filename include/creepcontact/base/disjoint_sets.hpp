#pragma once
/// Sets of numbered things that are joined, directly or by others.

#include <cstddef>
#include <numeric>
#include <vector>

namespace creepcontact {

class DisjointSets {
 public:
  /// @param n  things, each in a set of its own
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  /// One thing of the set, the same for all of them. Cost: nearly constant
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// @returns false if they were joined already
  bool join(std::size_t i, std::size_t j) {
    const std::size_t a = find(i), b = find(j);
    parent_[a] = b;
    return a != b;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace creepcontact
