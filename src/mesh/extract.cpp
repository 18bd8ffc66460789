#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "creepcontact/base/error.hpp"
#include "creepcontact/mesh/cell_faces.hpp"
#include "creepcontact/mesh/group_kind.hpp"
#include "creepcontact/mesh/mesh.hpp"
#include "face_key.hpp"

namespace creepcontact::mesh {
namespace {

using Marks = std::vector<std::vector<char>>;  // block by block, a mark a cell

Marks body_cells(const Mesh& parent, const std::vector<std::string>& regions) {
  Marks marks;
  for (const CellBlock& block : parent.blocks) marks.emplace_back(block.size(), char{0});
  for (const std::string& region : regions) {
    const Group& group = parent.group(region, parent.section.dimension());
    if (group.cells.empty())
      throw ModelError(fmt::format("physical {} '{}' has no cells", group_kind(group.dimension), region));
    for (const CellRef& ref : group.cells) marks[ref.block][ref.cell] = 1;
  }
  return marks;
}

std::vector<char> nodes_of(const Mesh& parent, const Marks& marks) {
  std::vector<char> used(parent.nodes.size(), char{0});
  for (std::size_t b = 0; b < parent.blocks.size(); ++b) {
    for (std::size_t c = 0; c < marks[b].size(); ++c) {
      if (!marks[b][c]) continue;
      for (std::int64_t node : parent.blocks[b].cell(c)) used[node] = 1;
    }
  }
  return used;
}

/// Marks the cells of lower dimension whose nodes all belong to the body.
void mark_lower(const Mesh& parent, const std::vector<char>& used, Marks& marks) {
  for (std::size_t b = 0; b < parent.blocks.size(); ++b) {
    const CellBlock& block = parent.blocks[b];
    if (dimension(block.type) >= parent.section.dimension()) continue;
    for (std::size_t c = 0; c < block.size(); ++c) {
      const auto cell = block.cell(c);
      marks[b][c] = std::all_of(cell.begin(), cell.end(), [&](std::int64_t n) { return used[n] != 0; });
    }
  }
}

/// Takes the mark from surface cells that are faces of the neighbour only: across the corner of a shared, bent
/// interface a face of the neighbour may have all its nodes in this body and yet be none of its faces.
void unmark_foreign_faces(const Mesh& parent, Marks& marks) {
  enum : char { foreign = 1, own = 2 };
  std::unordered_map<FaceKey, char, FaceKeyHash> sides;
  for (std::size_t b = 0; b < parent.blocks.size(); ++b) {
    const CellBlock& block = parent.blocks[b];
    if (dimension(block.type) != parent.section.dimension() - 1) continue;
    for (std::size_t c = 0; c < block.size(); ++c)
      if (marks[b][c]) sides.emplace(face_key(block.type, block.cell(c)), char{0});
  }
  for (std::size_t b = 0; b < parent.blocks.size(); ++b) {
    const CellBlock& block = parent.blocks[b];
    for (std::size_t c = 0; c < block.size(); ++c) {
      for (const LocalFace& face : cell_faces(block.type)) {
        const auto found = sides.find(face_key(face.type, [&](int i) { return block.cell(c)[face.nodes[i]]; }));
        if (found != sides.end()) found->second = std::max<char>(found->second, marks[b][c] ? own : foreign);
      }
    }
  }
  for (std::size_t b = 0; b < parent.blocks.size(); ++b) {
    const CellBlock& block = parent.blocks[b];
    if (dimension(block.type) != parent.section.dimension() - 1) continue;
    for (std::size_t c = 0; c < block.size(); ++c)
      if (marks[b][c]) marks[b][c] = sides.at(face_key(block.type, block.cell(c))) != foreign;
  }
}

constexpr std::size_t none = -1;

}  // namespace

BodyMesh extract(const Mesh& parent, const std::vector<std::string>& regions) {
  Marks marks = body_cells(parent, regions);
  const std::vector<char> used = nodes_of(parent, marks);
  mark_lower(parent, used, marks);
  unmark_foreign_faces(parent, marks);

  BodyMesh body;
  body.mesh.section = parent.section;
  std::vector<std::int64_t> number(parent.nodes.size(), -1);
  for (std::size_t i = 0; i < parent.nodes.size(); ++i) {
    if (!used[i]) continue;
    number[i] = static_cast<std::int64_t>(body.parent_node.size());
    body.parent_node.push_back(i);
    body.mesh.nodes.push_back(parent.nodes[i]);
    if (!parent.node_numbers.empty()) body.mesh.node_numbers.push_back(parent.node_numbers[i]);
  }

  if (parent.section.has_axial_node()) {
    Vector3 centre = Vector3::Zero();
    for (const Vector3& x : body.mesh.nodes) centre += x / static_cast<double>(body.mesh.nodes.size());
    body.mesh.axial_node = static_cast<std::int64_t>(body.mesh.nodes.size());
    body.mesh.nodes.push_back(centre);
  }

  std::vector<std::size_t> new_block(parent.blocks.size(), none);
  std::vector<std::vector<std::size_t>> new_cell(parent.blocks.size());
  for (std::size_t b = 0; b < parent.blocks.size(); ++b) {
    CellBlock block{parent.blocks[b].type, {}};
    new_cell[b].assign(marks[b].size(), none);
    for (std::size_t c = 0; c < marks[b].size(); ++c) {
      if (!marks[b][c]) continue;
      new_cell[b][c] = block.size();
      if (!parent.blocks[b].numbers.empty()) block.numbers.push_back(parent.blocks[b].numbers[c]);
      for (std::int64_t node : parent.blocks[b].cell(c)) block.connectivity.push_back(number[node]);
    }
    if (block.connectivity.empty()) continue;
    new_block[b] = body.mesh.blocks.size();
    body.mesh.blocks.push_back(std::move(block));
  }

  for (const auto& [key, group] : parent.groups) {
    Group kept{group.name, group.dimension, {}};
    for (const CellRef& ref : group.cells) {
      if (marks[ref.block][ref.cell]) kept.cells.push_back({new_block[ref.block], new_cell[ref.block][ref.cell]});
    }
    if (!kept.cells.empty()) body.mesh.groups.emplace(key, std::move(kept));
  }
  return body;
}

}  // namespace creepcontact::mesh
