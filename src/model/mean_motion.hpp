#pragma once
/// The motion of a reference point that fits the displacements of nodes best: [[rigid]], [[coupling]].

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/contact/geometry/equation_rows.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {

/// Nodes of one body and their weights.
struct WeightedNodes {
  std::size_t body = 0;
  std::vector<std::int64_t> nodes;
  std::vector<double> weights;
};

/// Weights of the nodes of a group are the integrals of their shape functions over it, or equal for curves and points
/// of solids; their sum is the area, or the number of nodes.
WeightedNodes weighted_nodes(std::size_t body, const mesh::Mesh& mesh, const std::string& group);
WeightedNodes equally_weighted(std::size_t body, std::vector<std::int64_t> nodes);

/// Displacement and small rotation about the origin, as linear functions of the displacements of nodes: the least
/// squares of the weighted deviations from the motion of a rigid body (Abaqus calls it a distributing coupling, Nastran
/// RBE3). A force and a moment at the origin are distributed by the transposed functions. In plane sections only x, y
/// and the rotation about z count, in axisymmetric ones only y.
class MeanMotion {
 public:
  MeanMotion(const std::vector<WeightedNodes>& parts, const std::vector<mesh::Mesh>& meshes, const Vector3& origin);

  /// Whether nodes tell a component: 0 to 2 displacement, 3 to 5 rotation. Nodes on a line do not tell the turn about
  /// it.
  bool knows(int component) const { return known_[static_cast<std::size_t>(component)]; }
  /// The terms of a component in one body, times a factor.
  std::vector<contact::EquationTerm> terms(std::size_t body, int component, double factor) const;
  /// Bodies with nodes, ascending.
  const std::vector<std::size_t>& bodies() const { return bodies_; }
  /// Adds forces and moments at the origin to the bodies. @param force, moment  functions of t
  void add_loads(const std::array<Function, 3>& force, const std::array<Function, 3>& moment, Bodies& bodies) const;

 private:
  struct Part {
    std::size_t body = 0;
    std::int64_t node = 0;
    Eigen::Matrix<double, 6, 3> motion;  // per displacement of the node
  };
  std::vector<Part> parts_;
  std::vector<std::size_t> bodies_;
  std::array<bool, 6> known_{};
};

}  // namespace creepcontact::model
