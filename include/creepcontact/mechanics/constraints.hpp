#pragma once
/// Supports of a body, and links between its nodes. Each support, by component or along a normal, is a condition n . u
/// = g(x, t) at its nodes. The conditions of a node are combined into an orthonormal frame: its leading directions are
/// held, the others are free. Linked nodes have no unknowns of their own: they follow other nodes, or the six of a
/// rigid surface, of which supports may hold some.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/base/checksum.hpp"
#include "creepcontact/base/function.hpp"
#include "creepcontact/linalg/stiffness_solver.hpp"
#include "creepcontact/mechanics/node_links.hpp"
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
  /// Supports of a node that follows another one act on that one.
  /// @throws ModelError naming two supports that contradict each other at a node, or those of a rigid surface: same
  /// direction, but different values at t = 0, t = 1 or a breakpoint; or links that contradict each other
  Constraints(const std::vector<Vector3>& nodes, const std::vector<Support>& supports, const NodeLinks& links = {});

  std::int64_t n_free() const;
  std::int64_t n_full() const;  ///< 3 n_nodes
  /// Free dofs of a node along the columns of its frame; -1 where held, and at linked nodes.
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
  /// Adds all that reduce() depends on.
  void add_to(Checksum& sum) const;
  /// C T for rows C on all dofs. The caller applies C to prescribed(t) where the right-hand sides need it.
  Eigen::SparseMatrix<double, Eigen::RowMajor> reduce_rows(
      const Eigen::SparseMatrix<double, Eigen::RowMajor>& rows) const;
  /// Number of held directions at a node, 0 to 3: the leading columns of its frame.
  int n_held(std::int64_t node) const;
  /// True if supports, those of a rigid surface included, leave the node no displacement along a unit vector but what
  /// they prescribe.
  bool holds(std::int64_t node, const Vector3& direction) const;
  /// A part factor * value(t) of a prescribed displacement.
  struct PrescribedPart {
    double factor = 0;
    const Function* value = nullptr;  ///< never null; of this object
  };
  /// Parts that add up to the displacement that supports prescribe along a direction which they hold, without those
  /// that are zero at all times. nullopt if it depends on the position, or is not zero and that of a rigid surface.
  std::optional<std::vector<PrescribedPart>> prescribed_along(std::int64_t node, const Vector3& direction) const;
  /// Conditions q . (t, s w) = 0 of the links on a rigid-body mode t + w x (x - centre) of all nodes; s is a length.
  Eigen::Matrix<double, Eigen::Dynamic, 6> conditions_on_motions(const std::vector<Vector3>& nodes,
                                                                 const Vector3& centre, double size) const;
  const NodeLinks& links() const { return links_; }
  /// True if the node follows another one by cyclic symmetry.
  bool is_turned(std::int64_t node) const { return turned_or_null(node) != nullptr; }

 private:
  /// A rigid surface whose six coordinates (d, w) about a centre are N free + P g(t).
  struct RigidSurface {
    struct Condition {
      Eigen::Matrix<double, 6, 1> row;  // on (d, w)
      Function value;
      Vector3 position;
    };
    std::vector<std::int64_t> nodes;
    std::vector<Vector3> arms;  // of the nodes, from the centre
    Vector3 centre;
    std::vector<Condition> conditions;
    Eigen::Matrix<double, 6, Eigen::Dynamic> free, prescribing;  // N and P
    std::int64_t first_free = 0;
  };
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
  const NodeLinks::Turned* turned_or_null(std::int64_t node) const;
  const RigidSurface* surface_or_null(std::int64_t node) const;
  void find_linked_nodes(const std::vector<Vector3>& nodes);
  void hold_rigid_surfaces(const std::vector<Vector3>& nodes, const std::vector<Support>& supports);
  void make_transformation(const std::vector<Vector3>& nodes);
  linalg::SparseMatrix reduce_linked(const linalg::SparseMatrix& lower) const;
  /// Completes the prescribed displacement at linked nodes. @returns false if all of it is zero there
  bool prescribed_at_links(double t, std::span<double> full) const;

  std::vector<ConditionsOfSupport> supports_;
  std::vector<std::int64_t> frame_of_node_;  // index into frames_, -1: not supported
  std::vector<Frame> frames_;
  std::vector<std::array<std::int64_t, 3>> free_index_;
  std::vector<std::int64_t> node_of_free_;

  NodeLinks links_;
  std::vector<std::int64_t> turned_;   // by node: index into links_.turned, -1: none. Empty without links
  std::vector<std::int64_t> surface_;  // by node: index into surfaces_, -1: none. Empty without links
  std::vector<RigidSurface> surfaces_;
  linalg::SparseMatrix transformation_;  // T; only with links
};

}  // namespace creepcontact::mechanics
