#pragma once
/// The volume elements of one type with the geometry of their integration points.
///
/// Kept per point: inverse Jacobian and weight (80 bytes) rather than all shape-function gradients (480 bytes for
/// hex20). The loops are bound by memory, so multiplying the table of reference derivatives, which stays in the
/// cache, by the inverse Jacobian is cheaper than reading the products.

#include <array>
#include <memory>

#include "creepcontact/fem/reference_element.hpp"
#include "creepcontact/mechanics/discretization.hpp"
#include "creepcontact/numerics/parallel.hpp"

namespace creepcontact::mechanics {

struct PointGeometry {
  double inverse[9];  ///< d xi_k / d x_j at [3 k + j]
  double weight;      ///< volume that belongs to the point
};

/// Values at a point of the three functions that, with 1/sqrt(volume), are an orthonormal basis of the linear functions
/// of the place with respect to the weights of the element's points.
using LinearFunctions = std::array<double, 3>;

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
  /// @throws ModelError if an element is inverted
  static std::unique_ptr<const ElementBlock> make(const mesh::CellBlock& cells, const std::vector<Vector3>& nodes,
                                                  BlockStart start);
  virtual ~ElementBlock() = default;

  mesh::CellType type() const { return reference_.type(); }
  std::size_t n_elements() const { return connectivity_.size() / n_nodes_; }
  std::size_t n_nodes() const { return n_nodes_; }
  std::size_t n_points() const { return n_points_; }  ///< per element
  std::size_t n_inner() const { return has_bubble() ? n_elements() : 0; }
  const BlockStart& start() const { return start_; }
  std::span<const std::int64_t> nodes(std::size_t e) const { return {connectivity_.data() + e * n_nodes_, n_nodes_}; }
  const std::vector<std::int64_t>& connectivity() const { return connectivity_; }
  /// n_elements x n_points of this block
  const std::vector<PointGeometry>& geometry() const { return geometry_; }
  /// Point values to node values within an element, n_nodes x n_points: least squares onto the linear functions of the
  /// corners, or onto all shape functions where there are as many points.
  const Eigen::MatrixXd& extrapolation() const { return extrapolation_; }
  /// Values of the mean stress at the points to the nodes, n_nodes x n_points: the fit by linear functions, evaluated
  /// at the nodes. @param nodes  coordinates of all nodes of the body. Precondition: a quadratic element
  Eigen::MatrixXd mean_stress_extrapolation(std::size_t e, const std::vector<Vector3>& nodes) const;
  /// True if the mean stress is projected where it is evaluated, but not in the stiffness of all elements.
  bool fits_mean_stress() const;
  /// Replaces the mean stress by its projection in such elements. @param stress  that of the body, n_points x 6
  virtual void fit_mean_stress(std::span<double> stress) const = 0;
  /// Volumes that belong to the points of an element.
  Eigen::VectorXd weights(std::size_t e) const;
  /// Coordinates of a point of an element.
  Vector3 point(std::size_t e, std::size_t p, const std::vector<Vector3>& nodes) const;

  // The loops over all elements of the block; see Discretization. Element forces: n_entries x 3 of the body.
  virtual void stress(std::span<const double> u, const ElasticState& elastic, CreepStrainView creep,
                      std::span<double> stress) const = 0;
  virtual void internal_force(std::span<const double> stress, std::span<double> element_forces) const = 0;
  virtual void initial_strain_force(const ElasticState& elastic, CreepStrainView creep,
                                    std::span<double> element_forces) const = 0;
  virtual void tangent_strain(std::span<const double> u, std::span<const Matrix6> moduli,
                              std::span<const double> initial_stress, std::span<double> strain) const = 0;
  virtual void initial_stress_force(std::span<const Matrix6> moduli, std::span<const double> initial_stress,
                                    std::span<double> element_forces) const = 0;

  /// @param inner_forces  += those on the bubbles, 3 per inner displacement of the body
  void body_force(std::span<const Vector3> force_density, std::span<double> element_forces,
                  std::span<double> inner_forces) const;
  /// 3 n_nodes square, node by node.
  Eigen::MatrixXd element_stiffness(std::size_t e, const ElasticState& elastic) const;
  Eigen::MatrixXd element_stiffness(std::size_t e, std::span<const Matrix6> moduli) const;

 protected:
  ElementBlock(const mesh::CellBlock& cells, const std::vector<Vector3>& nodes, BlockStart start);

  const fem::ReferenceElement& reference() const { return reference_; }
  /// Reference derivatives, n_points x n_nodes x 3.
  const std::vector<double>& derivatives() const { return derivatives_; }
  /// n_elements x n_points; empty where nothing is projected on linear functions.
  const std::vector<LinearFunctions>& linear_functions() const { return linear_functions_; }
  /// Share of the volumetric strain of an element that stays as it is, the rest being projected; see
  /// ReferenceElement::projects_distorted_elements_only(). Precondition: fits_mean_stress()
  double unprojected_part(std::size_t e) const { return unprojected_part_[e]; }
  /// Reference derivatives of the bubble, n_points x 3; empty without one.
  const std::vector<double>& bubble_derivatives() const { return bubble_derivatives_; }

 private:
  /// Functions of the place, orthonormal with respect to the weights of an element: n_points x 0, 1 or 4.
  Eigen::MatrixXd basis(std::size_t e) const;
  bool has_bubble() const { return !bubble_derivatives_.empty(); }
  /// Gradients of the shape functions at the points of an element, one column per point, three numbers per node; those
  /// of the bubble, less their mean, come last.
  Eigen::MatrixXd gradients(std::size_t e) const;
  /// Volumetric strain of unit displacements at the points, after the projection: as gradients().
  Eigen::MatrixXd volumetric_gradients(std::size_t e, const Eigen::MatrixXd& gradients) const;
  /// Eliminates the bubble from a stiffness.
  Eigen::MatrixXd condensed(const Eigen::MatrixXd& stiffness) const;
  void tabulate();
  void measure(const std::vector<Vector3>& nodes);
  void measure_distortion();
  void find_linear_functions(const std::vector<Vector3>& nodes);

  const fem::ReferenceElement& reference_;
  BlockStart start_;
  std::size_t n_nodes_, n_points_;
  std::vector<std::int64_t> connectivity_;
  std::vector<PointGeometry> geometry_;
  std::vector<LinearFunctions> linear_functions_;
  std::vector<double> unprojected_part_;
  std::vector<double> derivatives_;
  std::vector<double> bubble_derivatives_, bubble_values_;  // at the points; values for integrals of body forces
  Eigen::MatrixXd shape_;                                   // n_nodes x n_points
  Eigen::MatrixXd extrapolation_;
};

}  // namespace creepcontact::mechanics
