#include "creepcontact/mesh/box_tree.hpp"

#include <algorithm>
#include <boost/iterator/function_output_iterator.hpp>

#include "packed_rtree.hpp"

namespace creepcontact::mesh {
namespace {

using Boxes = std::vector<PackedRtree<RtreeBox>::value_type>;

RtreeBox rtree_box(const Eigen::AlignedBox3d& box) {
  return {rtree_point(box.min()), rtree_point(box.max())};
}

Boxes numbered(std::span<const Eigen::AlignedBox3d> boxes) {
  Boxes entries;
  entries.reserve(boxes.size());
  for (const Eigen::AlignedBox3d& box : boxes) entries.emplace_back(rtree_box(box), entries.size());
  return entries;
}

}  // namespace

struct BoxTree::Tree {
  PackedRtree<RtreeBox> entries;
};

BoxTree::BoxTree(std::span<const Eigen::AlignedBox3d> boxes)
    : tree_(new Tree{PackedRtree<RtreeBox>(numbered(boxes))}) {}
BoxTree::~BoxTree() = default;
BoxTree::BoxTree(BoxTree&&) noexcept = default;
BoxTree& BoxTree::operator=(BoxTree&&) noexcept = default;

std::vector<std::size_t> BoxTree::meeting(const Eigen::AlignedBox3d& box) const {
  std::vector<std::size_t> found;
  const auto take_index = [&](const auto& entry) { found.push_back(entry.second); };
  tree_->entries.query(boost::geometry::index::intersects(rtree_box(box)),
                       boost::make_function_output_iterator(take_index));
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace creepcontact::mesh
