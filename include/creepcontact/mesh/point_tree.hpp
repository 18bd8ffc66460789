#pragma once
/// Which points of a set are nearest to a place.

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "creepcontact/base/tensor.hpp"

namespace creepcontact::mesh {

struct Neighbour {
  std::size_t point = 0;  ///< index
  double distance = 0;    ///< from the place
};

/// R-tree of points. Immutable; safe for any number of threads.
/// Cost: O(n log n) to make, O(log n + points found) per query.
class PointTree {
 public:
  explicit PointTree(std::span<const Vector3> points);
  ~PointTree();
  PointTree(PointTree&&) noexcept;
  PointTree& operator=(PointTree&&) noexcept;

  /// The n nearest points (all, if there are fewer), the nearest first. Among points at the same distance the one of
  /// the lower index comes first; which of them are left out is open.
  std::vector<Neighbour> nearest(const Vector3& place, std::size_t n) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace creepcontact::mesh
