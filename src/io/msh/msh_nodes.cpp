#include "msh_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "creepcontact/base/error.hpp"

namespace creepcontact::io {

MshNodes::MshNodes(const MshContent& content, const std::string& file) : content_(content), file_(file) {
  const auto& tags = content.node_tags;
  std::vector<std::size_t> order(tags.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto before = [&](std::size_t a, std::size_t b) { return tags[a] < tags[b]; };
  if (!std::is_sorted(order.begin(), order.end(), before)) std::stable_sort(order.begin(), order.end(), before);
  tags_.reserve(order.size());
  position_.reserve(order.size());
  for (std::size_t position : order) {
    if (tags_.empty() || tags_.back() != tags[position]) {
      tags_.push_back(tags[position]);
      position_.push_back(position);
    } else if (content.nodes[position_.back()] != content.nodes[position]) {
      throw ModelError(
          fmt::format("{}: node {} appears twice, at different positions; write the mesh again", file, tags[position]));
    }
  }
  used_.assign(tags_.size(), false);
}

std::int64_t MshNodes::use(std::uint64_t tag, std::uint64_t element) {
  // most meshes number their nodes without gaps
  std::size_t number = tags_.empty() ? 0 : static_cast<std::size_t>(tag - tags_.front());
  if (number >= tags_.size() || tags_[number] != tag)
    number = std::lower_bound(tags_.begin(), tags_.end(), tag) - tags_.begin();
  if (number == tags_.size() || tags_[number] != tag) {
    throw ModelError(
        fmt::format("{}: element {} has the node {}, which is not among the nodes; the mesh is damaged: "
                    "write it again",
                    file_, element, tag));
  }
  used_[number] = true;
  return number;
}

void MshNodes::give_used(mesh::Mesh& mesh) const {
  std::vector<std::int64_t> number(used_.size(), -1);
  for (std::size_t i = 0; i < used_.size(); ++i) {
    if (!used_[i]) continue;
    number[i] = static_cast<std::int64_t>(mesh.nodes.size());
    mesh.nodes.push_back(content_.nodes[position_[i]]);
    mesh.node_numbers.push_back(static_cast<std::int64_t>(tags_[i]));
  }
  for (mesh::CellBlock& block : mesh.blocks) {
    for (std::int64_t& node : block.connectivity) node = number[node];
  }
}

}  // namespace creepcontact::io
