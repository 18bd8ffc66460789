#pragma once
/// What a .msh file says, before its physical groups become the groups of a Mesh.

#include <compare>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "creepcontact/base/tensor.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::io {

struct MshContent {
  /// A geometric entity, or a physical group.
  struct Key {
    int dimension = 0;
    int tag = 0;
    auto operator<=>(const Key&) const = default;
  };
  /// Elements of one type in one entity.
  struct Elements {
    Key entity;
    int type = 0;                      ///< Gmsh's number
    std::vector<std::uint64_t> tags;   ///< one per element
    std::vector<std::uint64_t> nodes;  ///< node tags, element by element, in Gmsh's order
  };

  std::map<Key, std::string> physical_names;  ///< of physical groups; not all have one
  std::map<Key, std::vector<int>> physicals;  ///< by entity: the tags of the physical groups it belongs to
  std::vector<std::uint64_t> node_tags;       ///< in the order of the file, with gaps as they are
  std::vector<Vector3> nodes;                 ///< as many as there are tags
  std::vector<Elements> elements;
};

/// The cells of the physical groups with their nodes, as read_mesh describes them.
/// @param file  name for messages
/// @throws ModelError if there is no physical volume with cells in it (telling a mesh of surfaces from one whose
/// volumes
///         are in no physical group), if a physical group holds cells of a kind this program has no element for, if one
///         name stands for several groups, if a cell names a node that does not exist, or if a node has two places
/// Cost: n log n in the number of cells.
mesh::Mesh import_msh(const MshContent& content, const std::string& file);

}  // namespace creepcontact::io
