#pragma once
/// Segment-based dual mortar method: the weighted gaps of a contact pair as linear functions of the displacements of
/// both bodies.

#include <Eigen/SparseCore>
#include <span>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/base/index.hpp"
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
};

/// gap = initial gap + slave_rows u_s + master_rows u_m   (weighted, [length^3]; >= 0 where the surfaces are apart).
///
/// Row i belongs to multiplier node i (unilateral); rows 3i..3i+2 to its x, y, z (tied; for node_ties see there). Along
/// a curved surface these three turn with the normal, so that a constant pressure is transmitted as on a flat one. The
/// multiplier lambda_i is the contact pressure [force/area] at its node, and rows^T lambda are the nodal forces: equal
/// and opposite on the two bodies.
/// Source: Wohlmuth (2000) dual multipliers; Puso and Laursen (2004) segments; Cichosz and Bischoff (2011) partly
/// covered facets.
struct MortarCoupling {
  ContactType type = ContactType::unilateral;
  std::vector<MultiplierNode> nodes;
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
  /// Weighted initial gap for a given gap function [length] at time t. @returns n_rows; zero for tied rows
  Eigen::VectorXd given_gap(const Function& gap, double t) const;
};

/// Integrates the coupling of two surfaces.
/// @param sliding  relative rigid-body modes of the two bodies that contact must not resist at all, such as a ring
/// turning on its shaft. At every point the component of the normal along their displacement is removed. A motion is
/// ignored at points where its displacement vanishes or is closer to the normal than to the surface.
/// @throws ModelError if the surfaces do not face each other anywhere
/// Cost: O(n log n) for n facets, plus about 50 points per segment.
MortarCoupling mortar_coupling(const Surface& slave, const Surface& master, ContactType type,
                               std::span<const mechanics::RigidMotion> sliding = {});

/// True if `first` should be the slave, the surface that carries the multipliers. Criteria in this order:
/// - the surface that supports do not hold along its normal
/// - the one better covered, if facets of the other extend far beyond it
/// - the softer body, if the moduli differ by more than a factor of 10
/// - the coarser surface where the two face each other
/// With the stiffer, finer side as the slave, the pressures are useless.
bool first_is_better_slave(const Surface& first, const Surface& second);

}  // namespace creepcontact::contact
