#pragma once
/// Search for the points of a set that are nearest to a position.

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "creepcontact/base/tensor.hpp"

namespace creepcontact::mesh {

/// One result of a search.
struct Neighbour {
  std::size_t point = 0;  ///< index in the set
  double distance = 0;    ///< from the position
};

/// R-tree of points. Immutable; safe for any number of threads.
/// Cost: O(n log n) to build, O(log n + points found) per query.
class PointTree {
 public:
  explicit PointTree(std::span<const Vector3> points);
  ~PointTree();
  PointTree(PointTree&&) noexcept;
  PointTree& operator=(PointTree&&) noexcept;

  /// The n nearest points (all, if there are fewer), nearest first; points at the same distance by ascending index.
  /// Which of several equally distant points are left out is unspecified.
  std::vector<Neighbour> nearest(const Vector3& position, std::size_t n) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace creepcontact::mesh
