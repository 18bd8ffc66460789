#include "creepcontact/mesh/point_tree.hpp"

#include <algorithm>
#include <boost/iterator/function_output_iterator.hpp>
#include <tuple>

#include "packed_rtree.hpp"

namespace creepcontact::mesh {
namespace {

using Entries = std::vector<PackedRtree<RtreePoint>::value_type>;

Entries numbered(std::span<const Vector3> points) {
  Entries entries;
  entries.reserve(points.size());
  for (const Vector3& x : points) entries.emplace_back(rtree_point(x), entries.size());
  return entries;
}

}  // namespace

struct PointTree::Tree {
  PackedRtree<RtreePoint> entries;
};

PointTree::PointTree(std::span<const Vector3> points) : tree_(new Tree{PackedRtree<RtreePoint>(numbered(points))}) {}
PointTree::~PointTree() = default;
PointTree::PointTree(PointTree&&) noexcept = default;
PointTree& PointTree::operator=(PointTree&&) noexcept = default;

std::vector<Neighbour> PointTree::nearest(const Vector3& position, std::size_t n) const {
  std::vector<Neighbour> found;
  const auto take = [&](const auto& entry) {
    const RtreePoint& x = entry.first;
    found.push_back({entry.second, (Vector3(x.get<0>(), x.get<1>(), x.get<2>()) - position).norm()});
  };
  tree_->entries.query(boost::geometry::index::nearest(rtree_point(position), static_cast<unsigned>(n)),
                       boost::make_function_output_iterator(take));
  std::sort(found.begin(), found.end(), [](const Neighbour& a, const Neighbour& b) {
    return std::tie(a.distance, a.point) < std::tie(b.distance, b.point);
  });
  return found;
}

}  // namespace creepcontact::mesh
