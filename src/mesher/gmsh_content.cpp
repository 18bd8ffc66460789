#include "gmsh_content.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <cstdlib>

#include "creepcontact/mesh/group_kind.hpp"

namespace creepcontact::mesher {
namespace {

void add_physicals(io::MshContent& content) {
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups);
  for (const auto& [dimension, tag] : groups) {
    std::string name;
    gmsh::model::getPhysicalName(dimension, tag, name);
    if (!name.empty()) content.physical_names[{dimension, tag}] = name;
    std::vector<int> entities;
    gmsh::model::getEntitiesForPhysicalGroup(dimension, tag, entities);
    for (int entity : entities)
      content.physicals[{dimension, std::abs(entity)}].push_back(tag);  // the sign: orientation
  }
}

void add_nodes(io::MshContent& content) {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parametric;
  gmsh::model::mesh::getNodes(tags, coordinates, parametric, -1, -1, false, false);
  content.node_tags.assign(tags.begin(), tags.end());
  for (std::size_t i = 0; i < tags.size(); ++i) content.nodes.emplace_back(&coordinates[3 * i]);
}

void add_elements(io::MshContent& content) {
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities);
  for (const auto& [dimension, tag] : entities) {
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> tags, nodes;
    gmsh::model::mesh::getElements(types, tags, nodes, dimension, tag);
    for (std::size_t k = 0; k < types.size(); ++k) {
      content.elements.push_back(
          {{dimension, tag}, types[k], {tags[k].begin(), tags[k].end()}, {nodes[k].begin(), nodes[k].end()}});
    }
  }
}

}  // namespace

io::MshContent gmsh_content() {
  io::MshContent content;
  add_physicals(content);
  add_nodes(content);
  add_elements(content);
  return content;
}

void name_entities(io::MshContent& content) {
  for (const io::MshContent::Elements& elements : content.elements) {
    const io::MshContent::Key entity = elements.entity;
    content.physical_names[entity] = fmt::format("{}_{}", mesh::group_kind(entity.dimension), entity.tag);
    content.physicals[entity] = {entity.tag};
  }
}

}  // namespace creepcontact::mesher
