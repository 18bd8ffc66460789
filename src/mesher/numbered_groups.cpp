#include "numbered_groups.hpp"

#include <fmt/format.h>

#include <iostream>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

namespace creepcontact::mesher {

namespace {

constexpr int point_type = 15;  // of Gmsh

}  // namespace

void warn(const std::string& text) {
  std::cerr << "Warning : " << text << std::endl;
}

void set_groups(const std::vector<NumberedGroup>& groups, io::MshContent& content) {
  using Elements = io::MshContent::Elements;
  std::unordered_map<std::uint64_t, std::vector<int>> groups_of;  // by element
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (const std::uint64_t element : groups[g].elements) groups_of[element].push_back(static_cast<int>(g) + 1);
  const std::vector<Elements> all = std::move(content.elements);
  content.elements.clear();
  content.physicals.clear();
  content.physical_names.clear();
  // Elements of the same groups are an entity.
  std::map<std::tuple<int, int, std::vector<int>>, Elements> blocks;
  std::map<std::pair<int, std::vector<int>>, int> entity_of;
  std::uint64_t last = 0;
  for (const Elements& block : all) {
    const std::size_t n = block.tags.empty() ? 0 : block.nodes.size() / block.tags.size();
    for (std::size_t i = 0; i < block.tags.size(); ++i) {
      last = std::max(last, block.tags[i]);
      const auto found = groups_of.find(block.tags[i]);
      if (found == groups_of.end()) continue;
      const int dimension = block.entity.dimension;
      const int entity =
          entity_of.try_emplace({dimension, found->second}, static_cast<int>(entity_of.size()) + 1).first->second;
      content.physicals[{dimension, entity}] = found->second;
      for (const int group : found->second)
        content.physical_names[{dimension, group}] = groups[static_cast<std::size_t>(group) - 1].name;
      Elements& into = blocks[{dimension, block.type, found->second}];
      into.entity = {dimension, entity};
      into.type = block.type;
      into.tags.push_back(block.tags[i]);
      const auto first = block.nodes.begin() + static_cast<std::ptrdiff_t>(n * i);
      into.nodes.insert(into.nodes.end(), first, first + static_cast<std::ptrdiff_t>(n));
    }
  }
  for (auto& [key, block] : blocks) content.elements.push_back(std::move(block));
  std::set<std::string> names_of_elements;
  for (const auto& [group, name] : content.physical_names) names_of_elements.insert(name);
  const std::unordered_set<std::uint64_t> known(content.node_tags.begin(), content.node_tags.end());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (groups[g].nodes.empty()) continue;
    std::string name = groups[g].name;
    if (names_of_elements.contains(name)) {
      name += " (nodes)";
      warn(fmt::format("of the groups called '{}' that of elements has the name, that of {} nodes is '{}'",
                       groups[g].name, groups[g].nodes.size(), name));
    }
    std::vector<std::uint64_t> nodes = groups[g].nodes;
    // Gmsh does not keep them.
    if (const std::size_t n = std::erase_if(nodes, [&](std::uint64_t node) { return !known.contains(node); }); n > 0)
      warn(fmt::format("{} of {} nodes of the group '{}' belong to no element and are left out", n,
                       groups[g].nodes.size(), groups[g].name));
    if (nodes.empty()) continue;
    const int number = static_cast<int>(g) + 1, entity = static_cast<int>(entity_of.size() + g) + 1;
    Elements points{{0, entity}, point_type, {}, std::move(nodes)};
    for (std::size_t i = 0; i < points.nodes.size(); ++i) points.tags.push_back(++last);
    content.physicals[{0, entity}] = {number};
    content.physical_names[{0, number}] = name;
    content.elements.push_back(std::move(points));
  }
}

}  // namespace creepcontact::mesher
