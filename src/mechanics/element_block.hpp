#pragma once
/// The volume elements of one type with the geometry of their integration points.
///
/// Kept per point: inverse Jacobian and weight (80 bytes) rather than all shape-function gradients (480 bytes for
/// hex20). Multiplying the table of reference derivatives, which stays in the cache, by the inverse Jacobian is cheaper
/// than reading the products. Numbers of one kind are adjacent for all points of an element: the points are the
/// vector lanes of the loops.

#include <memory>

#include "creepcontact/base/index.hpp"
#include "creepcontact/fem/reference_element.hpp"
#include "creepcontact/mechanics/discretization.hpp"
#include "element_view.hpp"
#include "lanes.hpp"

namespace creepcontact::mechanics {

/// Where the block starts in the numbering of the body.
struct BlockStart {
  std::size_t element = 0;
  std::size_t point = 0;
  std::size_t entry = 0;  ///< of the rows (element, local node), 3 numbers each, of the buffer of element forces
  std::size_t inner = 0;  ///< of the inner displacements (bubbles), one per element that has one
};

/// Immutable after construction. Element arguments are numbers within the block; point arrays belong to the body.
class ElementBlock {
 public:
  /// @param cells  of a type that carries material: volumes, in sections surfaces
  /// @throws ModelError if an element is inverted
  ElementBlock(const mesh::CellBlock& cells, const std::vector<Vector3>& nodes, const mesh::Section& section,
               BlockStart start);

  mesh::CellType type() const { return reference_.type(); }
  std::size_t n_elements() const { return connectivity_.size() / n_coupled_; }
  std::size_t n_nodes() const { return n_nodes_; }
  /// Nodes on which the stress in an element depends: its own, and in generalised plane strain the axial node.
  std::size_t n_coupled() const { return n_coupled_; }
  std::size_t n_points() const { return n_points_; }  ///< per element
  std::size_t n_inner() const { return has_bubble() ? n_elements() : 0; }
  const BlockStart& start() const { return start_; }
  std::span<const std::int64_t> nodes(std::size_t e) const { return coupled_nodes(e).first(n_nodes_); }
  std::span<const std::int64_t> coupled_nodes(std::size_t e) const {
    return {connectivity_.data() + e * n_coupled_, n_coupled_};
  }
  /// The coupled nodes of all elements.
  const std::vector<std::int64_t>& connectivity() const { return connectivity_; }
  /// Point values to node values within an element, n_nodes x n_points: least squares onto the linear functions of the
  /// corners, or onto all shape functions where there are as many points.
  const Eigen::MatrixXd& extrapolation() const { return extrapolation_; }
  /// Point values to values at the corners, n_corners x n_points: least squares onto the linear functions, with the
  /// weights of the rule.
  Eigen::MatrixXd to_corners() const;
  /// Values of the mean stress at the nodes, n_nodes x n: the fit by linear functions, evaluated there.
  /// @param at_points  n_points x n, of n fields @param nodes  coordinates of all nodes of the body
  /// Precondition: a quadratic element
  Eigen::MatrixXd mean_stress_at_nodes(std::size_t e, const std::vector<Vector3>& nodes,
                                       const Eigen::Ref<const Eigen::MatrixXd>& at_points) const;
  /// True if the mean stress is projected where it is evaluated, but not in the stiffness of all elements.
  bool fits_mean_stress() const;
  bool has_plane_stress() const { return section_.analysis == settings::Analysis::plane_stress; }
  /// Replaces the mean stress by its projection in such elements. @param stress  that of the body, n_points x 6
  void fit_mean_stress(std::span<double> stress) const;
  /// Volumes that belong to the points of an element.
  Eigen::Map<const Eigen::VectorXd> weights(std::size_t e) const {
    return {geometry(e) + 9 * n_points_, static_cast<Index>(n_points_)};
  }
  /// Coordinates of a point of an element.
  Vector3 point(std::size_t e, std::size_t p, const std::vector<Vector3>& nodes) const;

  // The loops over all elements of the block; see Discretization. Element forces: n_entries x 3 of the body.
  void stress(std::span<const double> u, const ElasticState& elastic, const CreepStrainView& creep,
              std::span<double> stress) const;
  void internal_force(std::span<const double> stress, std::span<double> element_forces) const;
  void initial_strain_force(const ElasticState& elastic, const CreepStrainView& creep,
                            std::span<double> element_forces) const;
  void tangent_strain(std::span<const double> u, std::span<const Matrix6> moduli,
                      std::span<const double> initial_stress, std::span<double> strain) const;
  void initial_stress_force(std::span<const Matrix6> moduli, std::span<const double> initial_stress,
                            std::span<double> element_forces) const;

  /// @param inner_forces  += those on the bubbles, 3 per inner displacement of the body
  void body_force(std::span<const Vector3> force_density, std::span<double> element_forces,
                  std::span<double> inner_forces) const;
  /// 3 n_coupled square, node by node.
  Eigen::MatrixXd element_stiffness(std::size_t e, const ElasticState& elastic) const;
  Eigen::MatrixXd element_stiffness(std::size_t e, std::span<const Matrix6> moduli) const;

 private:
  /// Calls work(view, e, number of its first point) for all elements, in unspecified order on all threads.
  template <typename Work>
  void for_each_element(const Work& work) const;
  ElementView view(std::size_t e) const;
  std::size_t dimension() const { return static_cast<std::size_t>(section_.dimension()); }
  Vector3 inner_force(const ElasticState& elastic, std::size_t e) const;
  /// Where the forces on the nodes of an element are among those of the body.
  double* forces_of(std::size_t e, std::span<double> element_forces) const;

  /// d xi_k / d x_j at column 3 k + j, then weights: n_points x 10, column by column.
  const double* geometry(std::size_t e) const { return geometry_.data() + 10 * n_points_ * e; }
  /// The three functions that, with 1/sqrt(volume), are an orthonormal basis of the linear functions of the place with
  /// respect to the weights: n_points x 3, column by column. Precondition: the type is projected on linear functions
  const double* linear_functions(std::size_t e) const { return linear_functions_.data() + 3 * n_points_ * e; }
  /// Share of the volumetric strain of an element that stays as it is, the rest being projected; see
  /// ReferenceElement::projects_distorted_elements_only(). Precondition: fits_mean_stress()
  double unprojected_part(std::size_t e) const { return unprojected_part_[e]; }
  /// 1/x at the points of an element. Precondition: an axisymmetric section
  const double* inverse_radius(std::size_t e) const { return inverse_radius_.data() + n_points_ * e; }
  /// Functions of the place, orthonormal with respect to the weights of an element: n_points x 0, 1 or 4.
  Eigen::MatrixXd basis(std::size_t e) const;
  bool has_bubble() const { return bubble_derivatives_.rows() > 0; }
  Matrix3 inverse_jacobian(std::size_t e, std::size_t p) const;
  /// Gradients of the shape functions at the points of an element, one column per point, three numbers per node; those
  /// of the bubble, less their mean, come last.
  Eigen::MatrixXd gradients(std::size_t e) const;
  /// Strain zz of unit displacements at the points where these are not gradients, as gradients(): hoop strain in
  /// axisymmetric sections, axial strain in generalised plane strain, else empty.
  Eigen::MatrixXd zz_strains(std::size_t e) const;
  /// Moduli for strains in the plane; in plane stress those with the strain zz eliminated.
  Matrix6 in_section(const Matrix6& moduli) const;
  /// Projection of the volumetric strain; none in plane stress, where nothing locks.
  fem::Projection projection() const;
  /// Volumetric strain of unit displacements at the points, after the projection: as gradients().
  Eigen::MatrixXd volumetric_gradients(std::size_t e, const Eigen::MatrixXd& divergence) const;
  /// Eliminates the bubble from a stiffness.
  Eigen::MatrixXd condensed(const Eigen::MatrixXd& stiffness) const;
  /// Nodes in full vectors.
  std::size_t n_padded() const { return (n_nodes_ + lanes - 1) / lanes * lanes; }
  void tabulate();
  void measure(const std::vector<Vector3>& nodes);
  void measure_distortion();
  void find_linear_functions(const std::vector<Vector3>& nodes);
  void measure_bubbles();

  const fem::ReferenceElement& reference_;
  const fem::QuadratureRule& rule_;
  mesh::Section section_;
  BlockStart start_;
  std::size_t n_nodes_, n_coupled_, n_points_;
  std::vector<std::int64_t> connectivity_;
  std::vector<double> geometry_;
  std::vector<double> inverse_radius_;
  std::vector<double> linear_functions_;
  std::vector<double> unprojected_part_;
  std::vector<Bubble> bubbles_;
  std::vector<double> derivatives_;            // of the reference, n_points x n_nodes x 3
  std::vector<double> derivative_lanes_;       // the same, n_nodes x 3 x n_points
  std::vector<double> derivatives_by_points_;  // the same, n_points x 3 x n_padded()
  std::vector<double> shape_lanes_;            // shape_, n_nodes x n_points
  std::vector<double> shape_by_points_;        // the same, n_points x n_padded()
  Eigen::MatrixX3d bubble_derivatives_;        // of the reference, n_points x 3; empty without a bubble
  std::vector<double> bubble_values_;          // at the points
  std::vector<double> bubble_shares_;          // the same for integrals of body forces
  Eigen::MatrixXd shape_;                      // n_nodes x n_points
  Eigen::MatrixXd extrapolation_;
};

}  // namespace creepcontact::mechanics
