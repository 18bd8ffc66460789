#pragma once
/// Segment-based dual mortar: the weighted gaps of a contact pair as linear functions of both bodies' displacements.

#include <Eigen/SparseCore>
#include <span>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/geometry/surface_normals.hpp"
#include "creepcontact/mechanics/rigid_motion.hpp"

namespace creepcontact::contact {

using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

enum class ContactType { unilateral, tied };

/// One surface of a pair.
struct Surface {
  std::string name;
  const mesh::Mesh* mesh = nullptr;
  const mechanics::Constraints* constraints = nullptr;
  std::vector<mesh::Face> faces;
  double young_modulus = 0;  ///< a typical value, for the choice of the slave
};

/// gap = initial gap + slave_rows u_s + master_rows u_m   (weighted, [length^3]; >= 0 where the surfaces are apart).
/// Row i belongs to multiplier node i (unilateral) or rows 3i..3i+2 to its x, y, z (tied). The multiplier lambda_i is
/// the contact pressure [force/area] of its node, and rows^T lambda are nodal forces: equal and opposite on both
/// bodies. Source: Wohlmuth (2000) dual multipliers; Puso and Laursen (2004) segments; Cichosz and Bischoff (2011)
/// partly covered facets.
struct MortarCoupling {
  ContactType type = ContactType::unilateral;
  std::vector<MultiplierNode> nodes;
  std::vector<double> area;  ///< surface area that belongs to each multiplier node
  RowMatrix slave_rows;      ///< n_rows x 3 n_slave_nodes
  RowMatrix master_rows;     ///< n_rows x 3 n_master_nodes

  /// Weighted initial gap as measured from the meshes, n_rows: between the smooth surfaces that linear faces stand for,
  /// since the facets' own distance errs by their sagitta.
  Eigen::VectorXd geometric_gap;
  /// Quadrature points of the slave surface and their weights in each multiplier's gap: weighted gap = gap_weights g.
  std::vector<Vector3> gap_points;
  std::vector<double> gap_distances;  ///< from each of them to the other surface as meshed; negative: they overlap
  RowMatrix gap_weights;              ///< n_nodes x n_points

  Index n_rows() const { return slave_rows.rows(); }
  /// Weighted initial gap of a given gap function at time t. @returns n_rows; tied rows have no gap
  Eigen::VectorXd given_gap(const Function& gap, double t) const;
};

/// @param sliding  relative rigid motions of the two bodies that contact leaves free exactly, as a ring's turning on
/// its
///   shaft: at every point the normal loses its part along their displacement. Where a motion's displacement vanishes,
///   or lies rather along the normal than across it, the motion is passed over.
/// @throws ModelError if the surfaces do not face each other anywhere
/// Cost: O(n log n) for n facets, then about 50 points a segment.
MortarCoupling mortar_coupling(const Surface& slave, const Surface& master, ContactType type,
                               std::span<const mechanics::RigidMotion> sliding = {});

/// True if `first` should carry the multipliers: the one that supports do not hold along its normal; else the one
/// that is covered, if facets of the other stick out far over it; else the softer body where the moduli differ by more
/// than 10, else the surface that is coarser where the two face each other. (The stiffer, finer side as slave gives
/// useless pressures.)
bool first_is_better_slave(const Surface& first, const Surface& second);

}  // namespace creepcontact::contact
