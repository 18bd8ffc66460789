#include "creepcontact/contact/geometry/box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace creepcontact::contact {
namespace {

constexpr std::size_t boxes_of_leaf = 4;

}  // namespace

BoxTree::BoxTree(const std::vector<Eigen::AlignedBox3d>& boxes) : boxes_(boxes), order_(boxes.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  nodes_.push_back({{}, 0, boxes.size(), 0});
  for (std::size_t node = 0; node < nodes_.size(); ++node) divide(node);
}

void BoxTree::divide(std::size_t node) {
  const std::size_t begin = nodes_[node].begin, end = nodes_[node].end;
  for (std::size_t i = begin; i < end; ++i) nodes_[node].box.extend(boxes_[order_[i]]);
  if (end - begin <= boxes_of_leaf) return;
  int longest = 0;
  nodes_[node].box.sizes().maxCoeff(&longest);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](std::size_t a, std::size_t b) {
    return boxes_[a].center()[longest] < boxes_[b].center()[longest];
  });
  nodes_[node].children = nodes_.size();
  nodes_.push_back({{}, begin, middle, 0});
  nodes_.push_back({{}, middle, end, 0});
}

std::vector<std::size_t> BoxTree::meeting(const Eigen::AlignedBox3d& box) const {
  std::vector<std::size_t> found, pending{0};
  while (!pending.empty()) {
    const Node& node = nodes_[pending.back()];
    pending.pop_back();
    if (!node.box.intersects(box)) continue;
    if (node.children > 0) {
      pending.push_back(node.children);
      pending.push_back(node.children + 1);
    } else {
      for (std::size_t i = node.begin; i < node.end; ++i)
        if (boxes_[order_[i]].intersects(box)) found.push_back(order_[i]);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace creepcontact::contact
