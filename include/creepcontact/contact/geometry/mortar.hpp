#pragma once
/// Segment-based dual mortar method: the weighted gaps of a contact pair as linear functions of the displacements of
/// both bodies.

#include <Eigen/SparseCore>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/geometry/sector.hpp"
#include "creepcontact/contact/geometry/surface_normals.hpp"
#include "creepcontact/mechanics/rigid_motion.hpp"
#include "creepcontact/settings/contact_settings.hpp"

namespace creepcontact::contact {

using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

using settings::ContactType;

/// One surface of a contact pair. Pointers must be valid during the calls below only.
struct Surface {
  std::string name;
  const mesh::Mesh* mesh = nullptr;
  const mechanics::Constraints* constraints = nullptr;
  std::vector<mesh::Face> faces;
  double young_modulus = 0;  ///< a typical value, used to choose the slave
  /// With cyclic symmetry: the surface continues in the adjacent sectors. Both surfaces of a pair have
  /// equal sectors.
  std::optional<Sector> sector = std::nullopt;
  /// Nodes where something else ties or presses the slave: their rows join those of the nearest other nodes, for two
  /// conditions on the same displacement would be one too many. Ascending.
  std::vector<std::int64_t> joining = {};
};

/// Two nodes at the same position that move together.
struct NodeTie {
  std::int64_t slave = 0, master = 0;
  double area = 0;  ///< > 0, of the surface around the node; converts the multiplier to a force per area
};

/// gap = initial gap + slave_rows u_s + master_rows u_m   (weighted, [length^3]; >= 0 where the surfaces are apart).
///
/// Each multiplier node has rows_per_node() rows, node after node:
/// - unilateral: one, along the normal. Its multiplier is the contact pressure [force/area].
/// - unilateral with friction: the normal one, then one per tangent (sections: one, solids: two). Their gaps are the
///   weighted relative tangential displacements, their multipliers the components of the shear traction.
/// - tied: x, y, z, or other axes (for node_ties see there).
/// Rows along directions in which a plane of symmetry holds both bodies are empty: their multipliers are zero, as in
/// the whole model. Along a curved surface the directions of a node turn with the normal, so that a constant pressure
/// is transmitted as on a flat one. rows^T lambda are the nodal forces: equal and opposite on the two bodies. The
/// traction on the master body is the sum of multipliers times directions. With cyclic symmetry the master may lie in
/// the sectors adjacent to that of the slave, and the two nodes that a link makes one in the full circle have one
/// multiplier.
///
/// Source: Wohlmuth (2000) dual multipliers; Puso and Laursen (2004) segments; Cichosz and Bischoff (2011) partly
/// covered facets.
struct MortarCoupling {
  /// A node of the slave that has the multiplier of the node that it follows by cyclic symmetry.
  struct Image {
    MultiplierNode at;
    std::size_t of = 0;  ///< index into nodes
  };

  ContactType type = ContactType::unilateral;
  std::vector<MultiplierNode> nodes;
  std::vector<Image> images;
  std::optional<Sector> sector = std::nullopt;  ///< that the surfaces are part of
  /// With friction: two unit vectors per node, orthogonal to its normal and to each other, the first along a direction
  /// that a support of the slave holds, if there is one. In sections only the first has a row. Empty without friction.
  std::vector<std::array<Vector3, 2>> tangents;
  /// Tied: directions of the rows of each node, as columns. Empty: x, y and z everywhere.
  std::vector<Matrix3> axes = {};
  /// Ties of the last nodes, which are joined to nodes of the master. Their rows are those of node_ties; with axes
  /// along which a node is held on both bodies, whose rows are empty.
  std::vector<NodeTie> ties = {};
  /// The tractions that multipliers mean, with such ties: 3 n_nodes x n_rows. Nodal forces of quadratic elements are
  /// not tractions, so those at corners are means over the faces around, weighted by the hat function of the corner, as
  /// multipliers of the mortar method are; those between are means of corners. Empty: multipliers along the axes.
  RowMatrix tractions = {};
  std::vector<double> area;  ///< surface area of each multiplier node
  RowMatrix slave_rows;      ///< n_rows x 3 n_slave_nodes
  RowMatrix master_rows;     ///< n_rows x 3 n_master_nodes

  /// Weighted initial gap measured from the meshes, n_rows. It is the gap between the smooth surfaces that linear faces
  /// approximate; the distance of the facets themselves would be wrong by their sagitta.
  Eigen::VectorXd geometric_gap;
  /// Quadrature points on the slave surface; their weights in the gap of each multiplier are gap_weights.
  std::vector<Vector3> gap_points;
  std::vector<double> gap_distances;  ///< from each point to the other surface as meshed; negative: overlap
  RowMatrix gap_weights;              ///< n_nodes x n_points: weighted gap = gap_weights g(gap_points)

  Index n_rows() const { return slave_rows.rows(); }
  bool has_friction() const { return !tangents.empty(); }
  Index rows_per_node() const { return nodes.empty() ? 1 : n_rows() / std::ssize(nodes); }
  /// First row of a node.
  Index row(std::size_t node) const { return static_cast<Index>(node) * rows_per_node(); }
  /// Contact pressure at a node. @param multiplier  n_rows, of this pair
  double pressure(std::size_t node, const Eigen::Ref<const Eigen::VectorXd>& multiplier) const;
  /// Shear traction on the master body at a node: the traction without its normal part.
  Vector3 shear(std::size_t node, const Eigen::Ref<const Eigen::VectorXd>& multiplier) const;
  /// Traction on the master body at a tied node with three rows. @param multiplier  n_rows
  Vector3 traction(std::size_t node, const Eigen::Ref<const Eigen::VectorXd>& multiplier) const;
  /// Sum of the traction over the area of a tied node with three rows: exact where the traction is a mean.
  Vector3 nodal_force(std::size_t node, const Eigen::Ref<const Eigen::VectorXd>& multiplier) const;
  /// Weighted gaps of the nodes on all rows: zero on those of ties and on tangential ones. @returns n_rows
  Eigen::VectorXd on_rows(const Eigen::VectorXd& of_nodes) const;
  /// One entry per node: that of its first row. @param of_rows  n_rows
  Eigen::VectorXd first_rows(const Eigen::Ref<const Eigen::VectorXd>& of_rows) const;
  /// Weighted initial gap for a given gap function [length] at time t. @returns n_rows; zero for tied and tangential
  /// rows
  Eigen::VectorXd given_gap(const Function& gap, double t) const;
};

/// Integrates the coupling of two surfaces.
/// @param friction  adds tangential rows; unilateral contacts only
/// @param sliding  relative rigid-body modes of the two bodies that contact must not resist at all, such as a ring
/// turning on its shaft. At every point the component of the normal along their displacement is removed. A motion is
/// ignored at points where its displacement vanishes or is closer to the normal than to the surface.
/// @throws ModelError if the surfaces do not face each other anywhere
/// Cost: O(n log n) for n facets, plus about 50 points per segment; with a sector three times the facets.
MortarCoupling mortar_coupling(const Surface& slave, const Surface& master, ContactType type,
                               std::span<const mechanics::RigidMotion> sliding = {}, bool friction = false);

/// Ties two surfaces: node to node where all nodes of a face lie on those of a face of the other surface (within 1e-5
/// of its size), which is exact, and by the mortar method elsewhere. Nodes of both parts are tied node to node; mortar
/// rows there join those of their neighbours.
/// @throws ModelError as mortar_coupling()
MortarCoupling tied_coupling(const Surface& slave, const Surface& master);

/// True if `first` should be the slave, the surface that carries the multipliers. Criteria in this order:
/// - the surface that supports do not hold along its normal
/// - the one better covered, if facets of the other extend far beyond it
/// - the softer body, if the moduli differ by more than a factor of 10
/// - the coarser surface where the two face each other
/// With the stiffer, finer side as the slave, the pressures are useless.
bool first_is_better_slave(const Surface& first, const Surface& second);

}  // namespace creepcontact::contact
