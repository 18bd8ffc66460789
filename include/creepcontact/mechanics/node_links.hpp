#pragma once
/// Nodes of a body whose displacement follows from that of others.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/base/tensor.hpp"

namespace creepcontact::mechanics {

struct NodeLinks {
  /// u(node) = rotation u(of): cyclic symmetry. A node may be linked to itself, on the axis.
  struct Turned {
    std::int64_t node = 0, of = 0;
    Matrix3 rotation = Matrix3::Identity();
  };
  /// u(node) = d + w x (x - origin) for all nodes of a surface, with small rotations w. What is not prescribed is free.
  struct Rigid {
    std::string on;  ///< name, for messages
    std::vector<std::int64_t> nodes;
    Vector3 origin = Vector3::Zero();
    std::array<std::optional<Function>, 3> displacement = {};  ///< components of d, of t
    std::array<std::optional<Function>, 3> rotation = {};      ///< components of w, of t
  };

  std::vector<Turned> turned;
  std::vector<std::string> turned_faces;  ///< groups of their nodes
  std::vector<Rigid> rigid;

  bool empty() const { return turned.empty() && rigid.empty(); }
};

}  // namespace creepcontact::mechanics
