#pragma once
/// One element as the loops see it. Arrays of values at the points have the points next to each other, or the nodes, so
/// that these are the lanes of the loops.

#include <cstddef>
#include <cstdint>

#include "creepcontact/base/tensor.hpp"
#include "creepcontact/fem/reference_element.hpp"

namespace creepcontact::mechanics {

/// What the bubble of an element has in common at all its points; g is its gradient less the mean.
struct Bubble {
  Vector3 mean_gradient;
  Matrix3 moments;  ///< sum of w l_j g_i at (j, i), with the linear functions l_j: the projection of g_i is their sum
  Matrix3 shear;    ///< sum of w (g g^T / 3 + g . g I): stiffness of the deviator for a shear modulus of 1
  /// Axisymmetric sections, where g is the gradient as it is, and the divergence has the hoop strain too: its mean for
  /// unit displacements. Else zero.
  Vector3 mean_divergence = Vector3::Zero();
};

/// Refers to arrays of the ElementBlock. n is the number of points.
struct ElementView {
  static constexpr std::size_t max_nodes = 27, max_points = 27;

  std::size_t n_nodes, n_points;
  const std::int64_t* nodes;            ///< those of the cell, and in generalised plane strain the axial node
  std::size_t n_padded;                 ///< n_nodes, or more, so that vectors of nodes are full
  const double* derivatives;            ///< dN_a/dxi_k, n_nodes x 3 x n
  const double* derivatives_by_points;  ///< the same, n x 3 x n_padded, with zeros
  const double* shape;                  ///< N_a, n_nodes x n
  const double* shape_by_points;        ///< the same, n x n_padded, with zeros
  const double* inverse;                ///< dxi_k/dx_j at column 3 k + j: 9 x n
  const double* weight;                 ///< n
  const double* linear;              ///< Projection::linear: the functions of ElementBlock::linear_functions(), 3 x n
  const double* inverse_radius;      ///< axisymmetric sections: 1/x, n
  const Bubble* bubble;              ///< nullptr without one
  const double* bubble_derivatives;  ///< with a bubble: reference derivatives, 3 x n
  const double* bubble_values;       ///< with a bubble: n
  fem::Projection projection;        ///< of the volumetric strain
  double unprojected;                ///< share of the volumetric strain that stays as it is
  double axial_length;               ///< mesh::Section::axial_length
  bool is_axisymmetric, has_axial_node, has_plane_stress;
};

}  // namespace creepcontact::mechanics
