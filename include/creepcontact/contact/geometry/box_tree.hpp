#pragma once
/// Which boxes of a set meet a given box.

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace creepcontact::contact {

/// Bounding-volume hierarchy of axis-aligned boxes, halved at the median of the longest side. Immutable.
/// Cost: O(n log n) to make, O(log n + boxes found) a query.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Eigen::AlignedBox3d>& boxes);

  /// Indices of the boxes that meet `box` (touching counts), ascending.
  std::vector<std::size_t> meeting(const Eigen::AlignedBox3d& box) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;         // of all that lies below
    std::size_t begin = 0, end = 0;  // range of order_
    std::size_t children = 0;        // index of the first of two; 0: a leaf
  };

  void divide(std::size_t node);

  std::vector<Eigen::AlignedBox3d> boxes_;
  std::vector<std::size_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace creepcontact::contact
