#pragma once
/// Mesh with named groups: nodes, blocks of cells of one type, groups of cells (Gmsh physical groups).

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "creepcontact/base/tensor.hpp"
#include "creepcontact/mesh/cell_type.hpp"
#include "creepcontact/mesh/section.hpp"

namespace creepcontact::mesh {

/// Cells of one type. `connectivity` is n_cells x n_nodes(type), row by row; node indices start at 0.
struct CellBlock {
  CellType type{};
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> numbers = {};  ///< of the cells in the mesh file; empty if the mesh is not from a file

  std::size_t size() const { return connectivity.size() / n_nodes(type); }
  std::span<const std::int64_t> cell(std::size_t i) const {
    const std::size_t n = n_nodes(type);
    return {connectivity.data() + i * n, n};
  }
};

/// Index of a cell: its block, and its number in the block.
struct CellRef {
  std::size_t block = 0, cell = 0;
};

/// A named set of cells of one dimension (0 point, 1 curve, 2 surface, 3 volume). A cell may belong to several groups.
struct Group {
  std::string name;
  int dimension = 0;
  std::vector<CellRef> cells;
};

/// Plain data; coordinates in the user's unit of length.
struct Mesh {
  std::vector<Vector3> nodes;
  std::vector<CellBlock> blocks;
  std::map<std::string, Group> groups;  // by name
  Section section = {};
  /// In generalised plane strain the last node, which no cell has: its displacement along z is the axial strain times
  /// Section::axial_length. Otherwise -1.
  std::int64_t axial_node = -1;
  /// Numbers of the nodes in the mesh file, ascending, without the axial node; empty if there is no file.
  std::vector<std::int64_t> node_numbers = {};

  /// Without the axial node.
  std::size_t n_cell_nodes() const { return nodes.size() - (axial_node < 0 ? 0 : 1); }
  /// True for the cells that carry material: volumes, or surfaces in sections.
  bool is_bulk(CellType type) const { return dimension(type) == section.dimension(); }

  /// @throws ModelError listing the existing groups and suggesting the nearest name, if there is no such group
  /// @param dimension  -1: any
  const Group& group(const std::string& name, int dimension = -1) const;
};

/// A face of a cell that carries material; by the right-hand rule its nodes give the outward normal of the cell. In
/// sections an edge, with the cell on its left.
struct Face {
  CellType type{};
  std::vector<std::int64_t> nodes;
};

/// The cells of some volume groups as a separate mesh.
/// Nodes are renumbered from 0; parent_node[i] is the number in the parent (an axial node has none, and is added).
/// Volume blocks contain only the cells of this body. Groups of lower dimension keep the cells whose nodes all belong
/// to the body.
struct BodyMesh {
  Mesh mesh;
  std::vector<std::int64_t> parent_node;
};
/// @throws ModelError if a region is missing, empty or not of the dimension of the section
BodyMesh extract(const Mesh& parent, const std::vector<std::string>& regions);

/// Faces of the cells of this mesh that lie on a surface group (in sections: a curve), oriented outward.
/// @throws ModelError if a surface cell is not a face of any volume cell, or lies between two volume cells
std::vector<Face> boundary_faces(const Mesh& mesh, const std::string& surface);

/// Nodes at the border of a surface: on edges that one face alone has; in sections the ends of a curve.
std::set<std::int64_t> border_nodes(const std::vector<Face>& faces);

/// Number of faces of a surface group that are not faces of any volume cell. Cost: one pass over all cells.
std::size_t n_orphan_faces(const Mesh& mesh, const std::string& surface);

/// Distinct nodes of a group of any dimension, ascending.
std::vector<std::int64_t> group_nodes(const Mesh& mesh, const std::string& name);

}  // namespace creepcontact::mesh
