#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/io/msh/msh_content.hpp"
#include "creepcontact/mesh/group_kind.hpp"
#include "msh_elements.hpp"
#include "msh_nodes.hpp"
#include "plane_mesh.hpp"

namespace creepcontact::io {
namespace {

using mesh::CellType;
using Key = MshContent::Key;

struct PhysicalGroup {
  std::string name;
  int dimension = 0;
  std::vector<Key> entities;
};

std::vector<PhysicalGroup> physical_groups(const MshContent& content, const std::string& file) {
  std::map<Key, PhysicalGroup> groups;
  for (const auto& [entity, physicals] : content.physicals) {
    for (int tag : physicals) groups[{entity.dimension, tag}].entities.push_back(entity);
  }
  std::vector<PhysicalGroup> result;
  std::map<std::string, int> dimension_of;
  for (auto& [key, group] : groups) {
    const auto named = content.physical_names.find(key);
    group.name = named == content.physical_names.end() ? std::to_string(key.tag) : named->second;
    group.dimension = key.dimension;
    const auto [known, is_new] = dimension_of.emplace(group.name, key.dimension);
    if (!is_new) {
      throw ModelError(
          fmt::format("{}: a physical {} and a physical {} are both called '{}'; give them different names", file,
                      mesh::group_kind(known->second), mesh::group_kind(key.dimension), group.name));
    }
    result.push_back(std::move(group));
  }
  return result;
}

[[noreturn]] void refuse(const PhysicalGroup& group, const MshElement& element, const std::string& file) {
  const std::string pyramids =
      "; Gmsh puts pyramids between hexahedra (of recombined or transfinite surfaces) and tetrahedra: mesh the whole "
      "volume with hexahedra or wedges (Transfinite Volume, or Extrude with Layers and Recombine), or leave out "
      "Recombine on its surfaces so that all cells become tetrahedra";
  throw ModelError(
      fmt::format("{}: physical {} '{}' has cells of the kind '{}', which are not supported; `creepcontact list "
                  "elements` names those that are{}",
                  file, mesh::group_kind(group.dimension), group.name, element.name(),
                  element.family == "Pyramid" ? pyramids : ""));
}

/// The cells of one type in all groups: row by row, as the file has them.
struct Cells {
  std::vector<std::uint64_t> tags;
  std::vector<std::int64_t> nodes;
  std::vector<Key> entities;
};

/// Numbers the cells by their tags. Where several have the same nodes (format 2.2 writes a cell once per group), the
/// one of the lowest tag remains, and has the entities of all.
mesh::CellBlock number_cells(CellType type, const Cells& cells, std::size_t block,
                             std::map<Key, std::vector<mesh::CellRef>>& cells_of) {
  const std::ptrdiff_t n = mesh::n_nodes(type);
  const auto row = [&](std::size_t cell) { return cells.nodes.begin() + cell * n; };
  const auto same = [&](std::size_t a, std::size_t b) { return std::equal(row(a), row(a) + n, row(b)); };
  std::vector<std::size_t> order(cells.tags.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const auto [at_a, at_b] = std::mismatch(row(a), row(a) + n, row(b));
    return at_a != row(a) + n ? *at_a < *at_b : cells.tags[a] < cells.tags[b];
  });
  std::vector<std::size_t> representative(order.size()), kept;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || !same(kept.back(), order[i])) kept.push_back(order[i]);
    representative[order[i]] = kept.back();
  }
  std::stable_sort(kept.begin(), kept.end(),
                   [&](std::size_t a, std::size_t b) { return cells.tags[a] < cells.tags[b]; });
  std::vector<std::size_t> number(order.size());
  mesh::CellBlock result{type, {}};
  result.connectivity.reserve(kept.size() * static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < kept.size(); ++i) {
    number[kept[i]] = i;
    result.numbers.push_back(static_cast<std::int64_t>(cells.tags[kept[i]]));
    result.connectivity.insert(result.connectivity.end(), row(kept[i]), row(kept[i]) + n);
  }
  for (std::size_t cell = 0; cell < order.size(); ++cell)
    cells_of[cells.entities[cell]].push_back({block, number[representative[cell]]});
  return result;
}

/// The cells of all groups, by type; their nodes as numbers of `nodes`.
std::map<CellType, Cells> collect(const MshContent& content, const std::vector<PhysicalGroup>& groups, MshNodes& nodes,
                                  const std::string& file) {
  std::map<Key, const PhysicalGroup*> group_of;
  for (const PhysicalGroup& group : groups) {
    for (const Key& entity : group.entities) group_of.emplace(entity, &group);
  }
  std::map<CellType, Cells> all;
  for (const MshContent::Elements& elements : content.elements) {
    const auto group = group_of.find(elements.entity);
    if (group == group_of.end() || elements.tags.empty()) continue;
    const MshElement& element = *msh_element(elements.type);
    if (!element.cell) refuse(*group->second, element, file);
    Cells& cells = all[*element.cell];
    cells.tags.insert(cells.tags.end(), elements.tags.begin(), elements.tags.end());
    cells.entities.insert(cells.entities.end(), elements.tags.size(), elements.entity);
    const std::size_t n = element.n_nodes;
    for (std::size_t i = 0; i < elements.nodes.size(); ++i)
      cells.nodes.push_back(nodes.use(elements.nodes[i], elements.tags[i / n]));
  }
  return all;
}

[[noreturn]] void refuse_without_bodies(const MshContent& content, const mesh::Section& section,
                                        const std::string& file) {
  int dimension = -1;
  for (const MshContent::Elements& elements : content.elements) {
    if (!elements.tags.empty()) dimension = std::max(dimension, elements.entity.dimension);
  }
  if (section.dimension() == 2) {
    throw ModelError(
        fmt::format("{}: the mesh has no physical surface with cells in it; with analysis = \"{}\" bodies are physical "
                    "surfaces: name them by `Physical Surface(\"name\") = {{...}};`{}",
                    file, settings::name_of(section.analysis),
                    dimension == 3 ? ". The mesh has volumes: for those, leave 'analysis' out" : ""));
  }
  if (dimension == 3) {
    throw ModelError(
        fmt::format("{}: the mesh has no physical volume with cells in it; name the bodies by `Physical "
                    "Volume(\"name\") = {{...}};`",
                    file));
  }
  if (dimension == 2) {
    throw ModelError(fmt::format(
        "{}: the mesh has only surface cells. If it is a section, say of what: analysis = \"axisymmetric\", "
        "\"plane_strain\", \"generalized_plane_strain\" or \"plane_stress\" at the top of the configuration. For a "
        "solid, "
        "make volumes of the surfaces (`Extrude`, or `Surface Loop` and `Volume`), name them by `Physical "
        "Volume(\"name\") = {{...}};`, and mesh in three dimensions (gmsh -3)",
        file));
  }
  throw ModelError(
      fmt::format("{}: the mesh has no physical volume with cells in it, nor any cell of a volume or a surface; bodies "
                  "are physical volumes: `Physical Volume(\"name\") = {{...}};`",
                  file));
}

}  // namespace

mesh::Mesh import_msh(const MshContent& content, const std::string& file, const mesh::Section& section) {
  const std::vector<PhysicalGroup> groups = physical_groups(content, file);
  MshNodes nodes(content, file);
  const std::map<CellType, Cells> all = collect(content, groups, nodes, file);

  mesh::Mesh result;
  result.section = section;
  std::map<Key, std::vector<mesh::CellRef>> cells_of;
  for (const auto& [type, cells] : all)
    result.blocks.push_back(number_cells(type, cells, result.blocks.size(), cells_of));
  nodes.give_used(result);

  bool has_bulk = false;
  for (const PhysicalGroup& group : groups) {
    mesh::Group filled{group.name, group.dimension, {}};
    auto& refs = filled.cells;
    for (const Key& entity : group.entities) {
      const auto& cells = cells_of[entity];
      refs.insert(refs.end(), cells.begin(), cells.end());
    }
    if (refs.empty()) {
      log::warning("{}: physical {} '{}' has no cells and is left out", file, mesh::group_kind(group.dimension),
                   group.name);
      continue;
    }
    const auto position = [](const mesh::CellRef& ref) { return std::pair(ref.block, ref.cell); };
    std::sort(refs.begin(), refs.end(), [&](const auto& a, const auto& b) { return position(a) < position(b); });
    refs.erase(
        std::unique(refs.begin(), refs.end(), [&](const auto& a, const auto& b) { return position(a) == position(b); }),
        refs.end());
    has_bulk |= group.dimension == section.dimension();
    result.groups.emplace(group.name, std::move(filled));
  }
  if (!has_bulk) refuse_without_bodies(content, section, file);
  if (section.dimension() == 2) check_plane_mesh(result, file);
  return result;
}

}  // namespace creepcontact::io
