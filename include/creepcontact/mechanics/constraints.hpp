#pragma once
/// Supports of a body. Each support, by component or along a normal, is a condition n . u = g(x, t) at its nodes. The
/// conditions of a node are combined into an orthonormal frame: its leading directions are held, the others are free.

#include <array>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/linalg/stiffness_solver.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mechanics {

/// The condition n . u = value at these nodes.
struct Support {
  std::string on;  ///< name, for messages and reactions
  std::vector<std::int64_t> nodes;
  std::vector<Vector3> directions;  ///< unit vectors: one per node, or one for all
  Function value;                   ///< [length], of x, y, z, t
};

/// Map u = T free + prescribed(t) between the free dofs and the displacement of all nodes (3 n_nodes). Immutable.
class Constraints {
 public:
  /// @throws ModelError naming two supports that contradict each other at a node: same direction, but different values
  /// at t = 0, t = 1 or a breakpoint
  Constraints(const std::vector<Vector3>& nodes, const std::vector<Support>& supports);

  std::int64_t n_free() const;
  std::int64_t n_full() const;  ///< 3 n_nodes
  /// Free dofs of a node along the columns of its frame; -1 where held.
  const std::array<std::int64_t, 3>& free_index(std::int64_t node) const;
  /// Columns: held directions first, then free ones; the identity at unsupported nodes.
  Matrix3 frame(std::int64_t node) const;
  /// Node of every free dof (for orderings).
  const std::vector<std::int64_t>& node_of_free() const;

  /// free = T^T full, e.g. of forces. Overwrites.
  void restrict_to_free(std::span<const double> full, std::span<double> free) const;
  /// full = T free + prescribed. Overwrites. @param prescribed  3 n_nodes
  void expand(std::span<const double> free, std::span<const double> prescribed, std::span<double> full) const;
  /// Prescribed displacement at time t (3 n_nodes). @returns false if all of it is zero
  bool prescribed(double t, std::span<double> full) const;
  /// True if some support prescribes a value other than zero.
  bool has_nonzero_values() const;
  /// T^T K T on the free dofs, lower triangle.
  /// @param lower  lower triangle of K on all dofs, with complete 3 x 3 blocks of nodes as from
  /// Discretization::stiffness()
  linalg::SparseMatrix reduce(const linalg::SparseMatrix& lower) const;
  /// C T for rows C on all dofs. The caller applies C to prescribed(t) where the right-hand sides need it.
  Eigen::SparseMatrix<double, Eigen::RowMajor> reduce_rows(
      const Eigen::SparseMatrix<double, Eigen::RowMajor>& rows) const;
  /// Number of held directions at a node, 0 to 3: the leading columns of its frame.
  int n_held(std::int64_t node) const;

 private:
  /// One independent condition of a node; contributes value(x, t) * displacement to the prescribed displacement.
  struct Condition {
    std::int64_t node = 0;
    Vector3 position, displacement;
  };
  struct ConditionsOfSupport {
    Function value;
    std::vector<Condition> conditions;
  };
  struct Frame {
    Matrix3 axes = Matrix3::Identity();
    int n_held = 0;
  };
  /// nullptr if the node is not supported.
  const Frame* frame_or_null(std::int64_t node) const;
  void number_free(std::int64_t n_nodes);

  std::vector<ConditionsOfSupport> supports_;
  std::vector<std::int64_t> frame_of_node_;  // index into frames_, -1: not supported
  std::vector<Frame> frames_;
  std::vector<std::array<std::int64_t, 3>> free_index_;
  std::vector<std::int64_t> node_of_free_;
};

}  // namespace creepcontact::mechanics
