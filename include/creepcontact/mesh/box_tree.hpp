#pragma once
/// Search for the boxes of a set that intersect a given box.

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace creepcontact::mesh {

/// R-tree of axis-aligned boxes. Immutable; safe for any number of threads.
/// Cost: O(n log n) to build, O(log n + boxes found) per query.
class BoxTree {
 public:
  explicit BoxTree(std::span<const Eigen::AlignedBox3d> boxes);
  ~BoxTree();
  BoxTree(BoxTree&&) noexcept;
  BoxTree& operator=(BoxTree&&) noexcept;

  /// Indices of the boxes that intersect `box` (touching counts), ascending.
  std::vector<std::size_t> meeting(const Eigen::AlignedBox3d& box) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace creepcontact::mesh
