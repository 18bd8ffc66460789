#include <cstdlib>
#include <limits>

#include "msh_elements.hpp"
#include "msh_sections.hpp"

namespace creepcontact::io {
namespace {

int read_dimension(MshInput& input, const char* what) {
  const int dimension = input.integer(what);
  if (dimension < 0 || dimension > 3)
    input.fail("{} is {}; it may be 0, 1, 2 or 3: the file is damaged, write it again", what, dimension);
  return dimension;
}

void skip_integers(MshInput& input, const char* count, const char* what) {
  const std::uint64_t n = input.size(count);
  input.expect_room(n, {1, 0}, what);
  for (std::uint64_t i = 0; i < n; ++i) input.integer(what);
}

void read_entity(MshInput& input, int dimension, bool partitioned, MshContent& content) {
  const MshContent::Key entity{dimension, input.integer("the number of an entity")};
  if (partitioned) {
    input.integer("the dimension of an entity's parent");
    input.integer("the parent of an entity");
    skip_integers(input, "how many partitions an entity has", "partitions of an entity");
  }
  input.skip_reals(dimension == 0 ? 3 : 6, "a coordinate of an entity");
  const std::uint64_t n_physicals = input.size("how many physical groups an entity is in");
  input.expect_room(n_physicals, {1, 0}, "physical groups of an entity");
  for (std::uint64_t i = 0; i < n_physicals; ++i) content.physicals[entity].push_back(read_physical_tag(input));
  if (dimension > 0) skip_integers(input, "how many entities bound an entity", "bounding entities");
}

/// The number of blocks, of items in all of them, and the least and the largest tag (not needed).
struct BlockCounts {
  explicit BlockCounts(MshInput& input)
      : blocks(input.size("the number of blocks")), items(input.size("the number in all blocks")) {
    input.size("the least tag");
    input.size("the largest tag");
  }
  std::uint64_t blocks, items;
};

void expect_total(const MshInput& input, std::uint64_t announced, std::uint64_t found, const char* what) {
  if (announced != found)
    input.fail("{} {} are announced, but the blocks contain {}; the file is damaged: write it again", announced, what,
               found);
}

}  // namespace

const MshElement& known_element(const MshInput& input, int type) {
  const MshElement* element = msh_element(type);
  if (element == nullptr)
    input.fail(
        "elements of type {} are unknown: Gmsh has no such type, or it is a polygon or polyhedron; mesh without "
        "them (`creepcontact list elements` names those that are supported)",
        type);
  return *element;
}

int read_physical_tag(MshInput& input) {
  const int tag = input.integer("the number of a physical group");
  if (tag == std::numeric_limits<int>::min())
    input.fail("the number of a physical group is {}; the file is damaged: write it again", tag);
  return std::abs(tag);
}

void skip_node_parameters(MshInput& input, int dimension, std::uint64_t n_nodes) {
  if (dimension < 0 || dimension > 3)
    input.fail("the dimension of a node's entity is {}; it may be 0, 1, 2 or 3: the file is damaged, write it again",
               dimension);
  input.skip_reals(n_nodes * static_cast<std::uint64_t>(dimension), "a parameter of a node");
}

void read_entities_41(MshInput& input, MshContent& content, bool partitioned) {
  if (partitioned) {
    input.size("the number of partitions");
    const std::uint64_t n_ghosts = input.size("the number of ghost entities");
    input.expect_room(n_ghosts, {2, 0}, "ghost entities");
    for (std::uint64_t i = 0; i < 2 * n_ghosts; ++i) input.integer("a ghost entity");
  }
  std::uint64_t counts[4];
  for (std::uint64_t& count : counts) count = input.size("the number of entities");
  for (int dimension = 0; dimension <= 3; ++dimension) {
    const std::uint64_t n = counts[dimension];
    input.expect_room(n, {1, dimension == 0 ? 4u : 8u}, "entities");
    for (std::uint64_t i = 0; i < n; ++i) read_entity(input, dimension, partitioned, content);
  }
}

void read_nodes_41(MshInput& input, MshContent& content) {
  const BlockCounts counts(input);
  input.expect_room(counts.items, {0, 4}, "nodes");
  content.node_tags.reserve(counts.items);
  content.nodes.reserve(counts.items);
  for (std::uint64_t block = 0; block < counts.blocks; ++block) {
    const int dimension = read_dimension(input, "the dimension of an entity with nodes");
    input.integer("the number of an entity with nodes");
    const bool parametric = input.integer("whether nodes have parameters") != 0;
    const std::uint64_t n = input.size("the number of nodes in a block");
    input.expect_room(n, {0, 4}, "nodes");
    for (std::uint64_t i = 0; i < n; ++i) content.node_tags.push_back(input.size("the number of a node"));
    for (std::uint64_t i = 0; i < n; ++i) {
      Vector3& node = content.nodes.emplace_back();
      for (int k = 0; k < 3; ++k) node[k] = input.real("a coordinate of a node");
      if (parametric) skip_node_parameters(input, dimension, 1);
    }
  }
  expect_total(input, counts.items, content.nodes.size(), "nodes");
}

void read_elements_41(MshInput& input, MshContent& content) {
  const BlockCounts counts(input);
  std::uint64_t found = 0;
  for (std::uint64_t block = 0; block < counts.blocks; ++block) {
    MshContent::Elements elements;
    elements.entity.dimension = read_dimension(input, "the dimension of an entity with elements");
    elements.entity.tag = input.integer("the number of an entity with elements");
    elements.type = input.integer("the type of elements");
    const MshElement& element = known_element(input, elements.type);
    if (element.dimension != elements.entity.dimension)
      input.fail("elements of the kind '{}' are in an entity of dimension {}; the file is damaged: write it again",
                 element.name(), elements.entity.dimension);
    const std::uint64_t n = input.size("the number of elements in a block");
    const auto n_nodes = static_cast<std::uint64_t>(element.n_nodes);
    input.expect_room(n, {0, 1 + n_nodes}, "elements");
    elements.tags.reserve(n);
    elements.nodes.reserve(n * n_nodes);
    for (std::uint64_t i = 0; i < n; ++i) {
      elements.tags.push_back(input.size("the number of an element"));
      for (std::uint64_t k = 0; k < n_nodes; ++k)
        elements.nodes.push_back(input.size("the number of a node of an element"));
    }
    found += n;
    content.elements.push_back(std::move(elements));
  }
  expect_total(input, counts.items, found, "elements");
}

}  // namespace creepcontact::io
