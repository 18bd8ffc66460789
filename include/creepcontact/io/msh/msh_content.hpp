#pragma once
/// Content of a .msh file, before its physical groups become groups of a Mesh.

#include <compare>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "creepcontact/base/tensor.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::io {

/// Entities, physical groups, nodes and elements as numbered in the file.
struct MshContent {
  /// Identifies a geometric entity or a physical group.
  struct Key {
    int dimension = 0;
    int tag = 0;
    auto operator<=>(const Key&) const = default;  // NOLINT(modernize-use-nullptr): it sees a 0 in the default
  };
  /// Elements of one type on one entity.
  struct Elements {
    Key entity;
    int type = 0;                      ///< element type number of Gmsh
    std::vector<std::uint64_t> tags;   ///< one per element
    std::vector<std::uint64_t> nodes;  ///< node tags, element by element, in Gmsh order
  };

  std::map<Key, std::string> physical_names;  ///< of physical groups; not all have a name
  std::map<Key, std::vector<int>> physicals;  ///< per entity: tags of the physical groups it belongs to
  std::vector<std::uint64_t> node_tags;       ///< in the order of the file; there may be gaps
  std::vector<Vector3> nodes;                 ///< coordinates, one per tag
  std::vector<Elements> elements;
};

/// Makes a mesh of the cells of the physical groups and their nodes, see read_mesh.
/// @param file  name for messages
/// @param section  what the mesh represents: bodies are physical volumes, in sections physical surfaces
/// @throws ModelError if there is no physical volume (surface) with cells; the message tells whether an analysis is
/// missing, or a physical group. Also for a section that is not in the plane z = 0, or has cells at negative radii.
/// Also for cells of an unsupported type in a physical group, a name of several groups, a cell with a node that does
/// not exist, or a node with two positions. Cost: O(n log n) for n cells.
mesh::Mesh import_msh(const MshContent& content, const std::string& file, const mesh::Section& section = {});

}  // namespace creepcontact::io
