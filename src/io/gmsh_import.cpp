#include "gmsh_import.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"

namespace creepcontact::io {
namespace {

using mesh::CellType;
using Entity = std::pair<int, int>;  // dimension, tag

constexpr std::array kinds{"point", "curve", "surface", "volume"};
const char* kind(int dimension) {
  return kinds[static_cast<std::size_t>(dimension)];
}

std::optional<CellType> cell_type(int gmsh_type) {
  static const std::map<int, CellType> types{{15, CellType::point1}, {1, CellType::line2},  {8, CellType::line3},
                                             {2, CellType::tri3},    {9, CellType::tri6},   {3, CellType::quad4},
                                             {16, CellType::quad8},  {10, CellType::quad9}, {4, CellType::tet4},
                                             {11, CellType::tet10},  {5, CellType::hex8},   {17, CellType::hex20},
                                             {12, CellType::hex27},  {6, CellType::wedge6}, {18, CellType::wedge15}};
  const auto found = types.find(gmsh_type);
  if (found == types.end()) return std::nullopt;
  return found->second;
}

std::string gmsh_type_name(int gmsh_type) {
  std::string name;
  int dimension = 0, order = 0, n_nodes = 0, n_primary = 0;
  std::vector<double> coordinates;
  gmsh::model::mesh::getElementProperties(gmsh_type, name, dimension, order, n_nodes, coordinates, n_primary);
  return name;
}

struct PhysicalGroup {
  std::string name;
  int dimension = 0;
  std::vector<int> entities;
};

std::vector<PhysicalGroup> physical_groups(const std::string& file) {
  std::vector<PhysicalGroup> groups;
  std::map<std::string, int> dimension_of;
  gmsh::vectorpair tags;
  gmsh::model::getPhysicalGroups(tags);
  for (const auto& [dimension, tag] : tags) {
    PhysicalGroup group{"", dimension, {}};
    gmsh::model::getPhysicalName(dimension, tag, group.name);
    if (group.name.empty()) group.name = std::to_string(tag);
    const auto [known, is_new] = dimension_of.emplace(group.name, dimension);
    if (!is_new) {
      throw ModelError(
          fmt::format("{}: a physical {} and a physical {} are both called '{}'; give them different names", file,
                      kind(known->second), kind(dimension), group.name));
    }
    gmsh::model::getEntitiesForPhysicalGroup(dimension, tag, group.entities);
    for (int& entity : group.entities) entity = std::abs(entity);  // the sign of format 2.2 is an orientation
    groups.push_back(std::move(group));
  }
  return groups;
}

/// A cell before it has its place in a block.
struct RawCell {
  std::size_t tag = 0;
  std::vector<std::size_t> nodes;
  std::vector<Entity> entities;
};
using RawBlocks = std::map<CellType, std::vector<RawCell>>;

void collect(const std::string& file, const PhysicalGroup& group, Entity entity, RawBlocks& blocks) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> tags, nodes;
  gmsh::model::mesh::getElements(types, tags, nodes, entity.first, entity.second);
  for (std::size_t k = 0; k < types.size(); ++k) {
    const auto type = cell_type(types[k]);
    if (!type) {
      throw ModelError(
          fmt::format("{}: physical {} '{}' has cells of the kind '{}', which are not supported; `list elements` names "
                      "those that are",
                      file, kind(group.dimension), group.name, gmsh_type_name(types[k])));
    }
    const auto n = static_cast<std::size_t>(mesh::n_nodes(*type));
    auto& cells = blocks[*type];
    for (std::size_t c = 0; c < tags[k].size(); ++c) {
      const auto begin = nodes[k].begin() + static_cast<std::ptrdiff_t>(c * n);
      cells.push_back({tags[k][c], {begin, begin + static_cast<std::ptrdiff_t>(n)}, {entity}});
    }
  }
}

/// Of several cells with the same nodes the one of the lowest tag stays, for the entities of all.
void unite_repeated(std::vector<RawCell>& cells) {
  std::sort(cells.begin(), cells.end(),
            [](const auto& a, const auto& b) { return std::tie(a.nodes, a.tag) < std::tie(b.nodes, b.tag); });
  std::size_t n_kept = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (n_kept == 0 || cells[n_kept - 1].nodes != cells[i].nodes) {
      if (n_kept != i) cells[n_kept] = std::move(cells[i]);
      ++n_kept;
      continue;
    }
    auto& entities = cells[n_kept - 1].entities;
    const Entity entity = cells[i].entities.front();
    if (std::find(entities.begin(), entities.end(), entity) == entities.end()) entities.push_back(entity);
  }
  cells.resize(n_kept);
}

std::vector<std::size_t> used_nodes(const RawBlocks& blocks) {
  std::vector<std::size_t> used;
  for (const auto& [type, cells] : blocks) {
    for (const RawCell& cell : cells) used.insert(used.end(), cell.nodes.begin(), cell.nodes.end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

std::vector<Vector3> node_coordinates(const std::vector<std::size_t>& used) {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parametric;
  gmsh::model::mesh::getNodes(tags, coordinates, parametric, -1, -1, false, false);
  std::vector<Vector3> nodes(used.size());
  for (std::size_t i = 0; i < tags.size(); ++i) {
    const auto found = std::lower_bound(used.begin(), used.end(), tags[i]);
    if (found == used.end() || *found != tags[i]) continue;
    nodes[static_cast<std::size_t>(found - used.begin())] = Vector3(&coordinates[3 * i]);
  }
  return nodes;
}

}  // namespace

mesh::Mesh import_model(const std::string& file, bool cells_may_repeat) {
  const std::vector<PhysicalGroup> groups = physical_groups(file);
  std::map<Entity, std::vector<mesh::CellRef>> cells_of;
  RawBlocks raw;
  for (const PhysicalGroup& group : groups) {
    for (int tag : group.entities) {
      const Entity entity{group.dimension, tag};
      if (cells_of.try_emplace(entity).second) collect(file, group, entity, raw);
    }
  }

  const std::vector<std::size_t> used = used_nodes(raw);
  mesh::Mesh result;
  result.nodes = node_coordinates(used);
  for (auto& [type, cells] : raw) {
    if (cells_may_repeat) unite_repeated(cells);
    std::sort(cells.begin(), cells.end(), [](const auto& a, const auto& b) { return a.tag < b.tag; });
    mesh::CellBlock block{type, {}};
    for (std::size_t c = 0; c < cells.size(); ++c) {
      for (const Entity& entity : cells[c].entities) cells_of[entity].push_back({result.blocks.size(), c});
      for (std::size_t node : cells[c].nodes)
        block.connectivity.push_back(std::lower_bound(used.begin(), used.end(), node) - used.begin());
    }
    result.blocks.push_back(std::move(block));
  }

  bool has_volume = false;
  for (const PhysicalGroup& group : groups) {
    mesh::Group filled{group.name, group.dimension, {}};
    for (int tag : group.entities) {
      const auto& cells = cells_of.at({group.dimension, tag});
      filled.cells.insert(filled.cells.end(), cells.begin(), cells.end());
    }
    if (filled.cells.empty()) {
      log::warning("{}: physical {} '{}' has no cells and is left out", file, kind(group.dimension), group.name);
      continue;
    }
    const auto place = [](const mesh::CellRef& ref) { return std::pair(ref.block, ref.cell); };
    auto& refs = filled.cells;
    std::sort(refs.begin(), refs.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
    refs.erase(
        std::unique(refs.begin(), refs.end(), [&](const auto& a, const auto& b) { return place(a) == place(b); }),
        refs.end());
    has_volume |= group.dimension == 3;
    result.groups.emplace(group.name, std::move(filled));
  }
  if (!has_volume) {
    throw ModelError(
        fmt::format("{}: the mesh has no physical volume with cells in it; name the bodies by `Physical "
                    "Volume(\"name\") = {{...}};`",
                    file));
  }
  return result;
}

}  // namespace creepcontact::io
