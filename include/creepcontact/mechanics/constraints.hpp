#pragma once
/// Supports of a body. Every support, by component or along a normal, is a condition n . u = g(x, t) at a node; the
/// conditions of a node are gathered into an orthonormal frame whose leading directions are held, the others free.

#include <array>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/linalg/stiffness_solver.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mechanics {

/// n . u = value at these nodes. `directions` has one entry, or one a node (unit vectors).
struct Support {
  std::string on;  ///< name for messages and reactions
  std::vector<std::int64_t> nodes;
  std::vector<Vector3> directions;
  Function value;  ///< of x, y, z, t
};

class Constraints {
 public:
  /// @throws ModelError if two supports of a node contradict each other (same direction, different values at t = 0,
  ///         at t = 1 or at a breakpoint), naming both
  Constraints(const std::vector<Vector3>& nodes, const std::vector<Support>& supports);

  std::int64_t n_free() const;
  std::int64_t n_full() const;  ///< 3 n_nodes
  /// Free unknowns of a node in its frame, -1 where held.
  const std::array<std::int64_t, 3>& free_index(std::int64_t node) const;
  /// Columns are the directions that free_index() numbers; identity at unsupported nodes.
  Matrix3 frame(std::int64_t node) const;
  /// Node of every free unknown (for ordering).
  const std::vector<std::int64_t>& node_of_free() const;

  /// full (3 n_nodes, Cartesian) -> free (forces: T^T f). Overwrites.
  void restrict_to_free(std::span<const double> full, std::span<double> free) const;
  /// free -> full displacement: u = T free + prescribed(t). Overwrites.
  void expand(std::span<const double> free, std::span<const double> prescribed, std::span<double> full) const;
  /// The prescribed part of the displacement at time t (3 n_nodes). @returns false if it is all zero
  bool prescribed(double t, std::span<double> full) const;
  bool has_nonzero_values() const;
  /// T^T K T for the lower triangle of a full matrix, lower triangle again.
  /// @param lower  pattern in whole 3 x 3 blocks of nodes, as Discretization::stiffness() makes it
  linalg::SparseMatrix reduce(const linalg::SparseMatrix& lower) const;
  /// Sparse rows over full dofs -> rows over free dofs (C T), and for constraint right-hand sides the caller applies
  /// the rows to prescribed(t) itself.
  Eigen::SparseMatrix<double, Eigen::RowMajor> reduce_rows(
      const Eigen::SparseMatrix<double, Eigen::RowMajor>& rows) const;
  /// Rank of the held directions at a node: 0 ... 3, and the held directions (leading columns of the frame).
  int n_held(std::int64_t node) const;

 private:
  /// One independent condition of a node: it adds value(x, t) * displacement to the prescribed displacement.
  struct Condition {
    std::int64_t node = 0;
    Vector3 place, displacement;
  };
  struct ConditionsOfSupport {
    Function value;
    std::vector<Condition> conditions;
  };
  struct Frame {
    Matrix3 axes = Matrix3::Identity();
    int n_held = 0;
  };
  /// nullptr where the node is not supported
  const Frame* frame_or_null(std::int64_t node) const;
  void number_free(std::int64_t n_nodes);

  std::vector<ConditionsOfSupport> supports_;
  std::vector<std::int64_t> frame_of_node_;  // index into frames_, -1: not supported
  std::vector<Frame> frames_;
  std::vector<std::array<std::int64_t, 3>> free_index_;
  std::vector<std::int64_t> node_of_free_;
};

}  // namespace creepcontact::mechanics
