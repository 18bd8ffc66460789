#include <optional>

#include "msh_elements.hpp"
#include "msh_sections.hpp"

namespace creepcontact::io {
namespace {

/// Counts of format 2.2 are text in binary files too.
std::uint64_t text_count(MshInput& input, const char* items, const MshRecord& record) {
  input.use_binary(false);
  const auto count = static_cast<std::uint64_t>(input.non_negative("a count"));
  input.use_binary(true);
  input.expect_room(count, record, items);
  input.line();
  return count;
}

/// Sorts elements into blocks by type and physical group.
class ElementBlocks {
 public:
  explicit ElementBlocks(MshContent& content) : content_(content) {}

  MshContent::Elements& block(int dimension, int physical, int type) {
    const Id id{{dimension, physical}, type};
    if (last_ && last_->first == id) return content_.elements[last_->second];
    const auto [known, is_new] = blocks_.try_emplace(id, content_.elements.size());
    if (is_new) {
      content_.elements.push_back({id.first, type, {}, {}});
      if (physical != 0) content_.physicals[id.first] = {physical};
    }
    last_ = *known;
    return content_.elements[known->second];
  }

 private:
  using Id = std::pair<MshContent::Key, int>;
  MshContent& content_;
  std::map<Id, std::size_t> blocks_;
  std::optional<std::pair<Id, std::size_t>> last_;
};

void read_element(MshInput& input, int tag, const MshElement& element, int type, int n_tags, ElementBlocks& blocks) {
  int physical = 0;
  for (int i = 0; i < n_tags; ++i) {
    if (i == 0)
      physical = read_physical_tag(input);
    else
      input.integer("a tag of an element");  // the entity, partitions
  }
  MshContent::Elements& block = blocks.block(element.dimension, physical, type);
  block.tags.push_back(static_cast<std::uint64_t>(tag));
  for (int i = 0; i < element.n_nodes; ++i)
    block.nodes.push_back(static_cast<std::uint64_t>(input.non_negative("the number of a node of an element")));
}

}  // namespace

void read_nodes_22(MshInput& input, MshContent& content, bool parametric) {
  const std::uint64_t n_nodes = text_count(input, "nodes", {parametric ? 3u : 1u, 3});
  content.node_tags.reserve(n_nodes);
  content.nodes.reserve(n_nodes);
  for (std::uint64_t i = 0; i < n_nodes; ++i) {
    content.node_tags.push_back(static_cast<std::uint64_t>(input.non_negative("the number of a node")));
    Vector3& node = content.nodes.emplace_back();
    for (int k = 0; k < 3; ++k) node[k] = input.real("a coordinate of a node");
    if (!parametric) continue;
    const int dimension = input.integer("the dimension of a node's entity");
    input.integer("the entity of a node");
    // volumes have no parameters in this format
    skip_node_parameters(input, dimension == 3 ? 0 : dimension, 1);
  }
}

void read_elements_22(MshInput& input, MshContent& content) {
  const std::uint64_t n_elements = text_count(input, "elements", {input.file_is_binary() ? 1u : 4u, 0});
  ElementBlocks blocks(content);
  if (!input.file_is_binary()) {
    for (std::uint64_t i = 0; i < n_elements; ++i) {
      const int tag = input.non_negative("the number of an element");
      const int type = input.integer("the type of an element");
      const int n_tags = input.non_negative("how many tags an element has");
      read_element(input, tag, known_element(input, type), type, n_tags, blocks);
    }
    return;
  }
  for (std::uint64_t read = 0; read < n_elements;) {
    const int type = input.integer("the type of elements");
    const auto n_following = static_cast<std::uint64_t>(input.non_negative("the number of elements of one type"));
    const int n_tags = input.non_negative("how many tags elements have");
    const MshElement& element = known_element(input, type);
    if (n_following == 0 || n_following > n_elements - read)
      input.fail("{} elements of one type follow where {} are left; the file is damaged: write it again", n_following,
                 n_elements - read);
    input.expect_room(n_following,
                      {1 + static_cast<std::uint64_t>(n_tags) + static_cast<std::uint64_t>(element.n_nodes), 0},
                      "elements");
    for (std::uint64_t i = 0; i < n_following; ++i)
      read_element(input, input.non_negative("the number of an element"), element, type, n_tags, blocks);
    read += n_following;
  }
}

}  // namespace creepcontact::io
