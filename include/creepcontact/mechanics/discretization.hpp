#pragma once
/// Integration points of a body and the element loops on it: strain, stress, nodal forces, stiffness. Displacements and
/// nodal forces have 3 n_nodes entries, node by node; stresses and strains n_points x 6 in Mandel order.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "creepcontact/linalg/stiffness_solver.hpp"
#include "creepcontact/material/material.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mechanics {

using material::Moduli;

class ElementBlock;          // // the elements of one type (implementation)
class LinearReconstruction;  // // gradients of element means (implementation)
class NodeEntries;           // // which element forces belong to a node (implementation)

/// View of the creep strain inside a state vector: the six components of point p start at data[p * stride]. Empty:
/// none. Valid as long as the vector.
struct CreepStrainView {
  std::span<const double> data = {};
  std::size_t stride = 6;
  bool empty() const { return data.empty(); }
  tensor::ConstMap at(std::size_t point) const { return tensor::ConstMap(&data[stride * point]); }
};

/// Elastic material data at all points. Isotropic moduli: one for all points, or one per point. Thermal strain: one
/// equal normal strain per point. Forces on the inner displacements: 3 n_inner. Matrices of anisotropic elasticity: one
/// per point; the isotropic moduli are then averages for scales. All but the moduli may be empty. Refers to values of
/// the caller.
struct ElasticState {
  std::span<const Moduli> moduli;
  std::span<const double> thermal_strain = {};
  std::span<const double> inner_force = {};
  std::span<const Matrix6> matrices = {};
  std::span<const double> thermal_tensors =
      {};  ///< n_points x 6: if it differs along the axes, instead of thermal_strain
  const Moduli& at(std::size_t point) const { return moduli[moduli.size() == 1 ? 0 : point]; }

  /// Stress for an elastic strain at a point, and back.
  Tensor6 stress(std::size_t point, const Tensor6& elastic_strain) const {
    return matrices.empty() ? material::stress(at(point), elastic_strain) : Tensor6(matrices[point] * elastic_strain);
  }
  Tensor6 thermal(std::size_t point) const {
    if (!thermal_tensors.empty()) return tensor::view(thermal_tensors, point);
    return (thermal_strain.empty() ? 0.0 : thermal_strain[point]) * tensor::identity();
  }
  bool has_thermal_strain() const { return !thermal_strain.empty() || !thermal_tensors.empty(); }
  /// Cost with matrices: a decomposition.
  Tensor6 elastic_strain(std::size_t point, const Tensor6& stress) const;
};

/// Nodes, section and some of the bulk cells of a mesh, without groups. @param elements  numbers among them, ascending
mesh::Mesh some_elements(const mesh::Mesh& mesh, std::span<const std::size_t> elements);

/// Creep is incompressible, so large creep strains make the total strain almost incompressible. To avoid locking, the
/// volumetric part of the elastic strain (total less creep and thermal strain) is projected. In hex8 and wedge6 it is
/// projected on a constant (B-bar, Hughes 1980), in quadratic elements on linear functions of the position (in hex20 to
/// the extent that they are distorted). tet10 and wedge15 also have an inner displacement (fem/bubble.hpp), which is
/// eliminated per element: arguments u are nodal displacements, and stress and strain include the inner displacement in
/// equilibrium.
///
/// The loops use all threads; results are the same to the last bit for any number of threads. Immutable.
class Discretization {
 public:
  /// Takes the volume cells of the mesh, block by block; cells of lower dimension are ignored.
  /// @throws ModelError if there are none, or naming an element with Jacobian <= 0 and its position
  explicit Discretization(const mesh::Mesh& mesh);
  /// That of some of its elements on the same nodes; possibly of none. It does not smooth (fit_mean_stress, to_nodes),
  /// which needs the neighbours. @param elements  ascending
  static Discretization part(const mesh::Mesh& mesh, std::span<const std::size_t> elements);

  std::size_t n_nodes() const;
  std::size_t n_elements() const;
  std::size_t n_points() const;
  /// Number of inner displacements, one per tet10 and wedge15.
  std::size_t n_inner() const;
  std::span<const Vector3> point_coordinates() const;
  /// Integration weight times Jacobian per point: the volume it represents.
  std::span<const double> weights() const;
  /// The points of an element are contiguous: element e has [first_point(e), first_point(e+1)).
  std::size_t first_point(std::size_t element) const;
  /// The inner displacement of an element; nullopt if it has none.
  std::optional<std::size_t> inner(std::size_t element) const;
  std::span<const std::int64_t> element_nodes(std::size_t element) const;
  mesh::CellType element_type(std::size_t element) const;

  /// stress = H (B u - creep strain - thermal strain). @param stress  n_points x 6
  void stress(std::span<const double> u, const ElasticState& elastic, CreepStrainView creep,
              std::span<double> stress) const;
  /// forces += integral B^T stress, for a stress in equilibrium with the forces on the inner displacements.
  void add_internal_force(std::span<const double> stress, std::span<double> forces) const;
  /// forces += integral B^T H (creep strain + thermal strain)
  void add_initial_strain_force(const ElasticState& elastic, CreepStrainView creep, std::span<double> forces) const;
  /// Strain B u for the law stress = D strain - initial_stress, with the inner displacements in equilibrium with it.
  /// @param moduli  D, symmetric, one per point @param strain  n_points x 6
  void tangent_strain(std::span<const double> u, std::span<const Matrix6> moduli,
                      std::span<const double> initial_stress, std::span<double> strain) const;
  /// forces += nodal forces of the initial stress at u = 0: integral B^T initial_stress, less what the inner
  /// displacements take.
  void add_initial_stress_force(std::span<const Matrix6> moduli, std::span<const double> initial_stress,
                                std::span<double> forces) const;
  /// forces += integral N^T force_density. @param force_density  force/volume per point, n_points
  /// @param forces  3 (n_nodes + n_inner): those on the inner displacements come last, as ElasticState takes them
  void add_body_force(std::span<const Vector3> force_density, std::span<double> forces) const;

  /// Values at the corners of an element from those at its points, n_corners x n_points: of the linear function that is
  /// nearest to them in the sense of least squares weighted as the quadrature. With three points per direction the
  /// error of quadratic elements drops out, whose leading part is orthogonal to linear functions.
  Eigen::MatrixXd to_corners(std::size_t element) const;

  /// True if fit_mean_stress() uses values of neighbouring elements, as it does in linear elements and tet10.
  bool smooths_over_neighbours() const { return reconstruction_ != nullptr; }
  /// True if fit_mean_stress() has an effect: the body has linear, hex20 or tet10 elements.
  bool fits_mean_stress() const;
  /// Smooths the mean stress at the points. In hex20 it is replaced by its fit by a linear function per element; in
  /// linear elements and tet10 by the mean of its values at their corners, with the gradient of the surrounding element
  /// means. The part removed (checkerboards of distorted meshes, gradients in flat tetrahedra) balances nodal forces,
  /// but does not approximate the mean stress. So use the result where the mean or a principal stress is evaluated, not
  /// for add_internal_force(). Linear fields do not change. @param stress  n_points x 6
  void fit_mean_stress(std::span<double> stress) const;

  /// Stiffness on all 3 n_nodes dofs, lower triangle. Cost: assembly.
  linalg::SparseMatrix stiffness(const ElasticState& elastic) const;
  /// integral B^T D B for arbitrary symmetric moduli D, one per point; same pattern.
  linalg::SparseMatrix stiffness(std::span<const Matrix6> moduli) const;

  /// Point values (n_points x width) to nodal values (n_nodes x width): the volume-weighted mean of the values that the
  /// elements of a node extrapolate to it. Quadratic elements extrapolate from their points by least squares, linear
  /// ones from their mean with the gradient of the means of their neighbours. Exact for linear fields. Cost: about 100
  /// operations per neighbour.
  void to_nodes(std::span<const double> point_values, int width, std::span<double> node_values) const;
  /// Extrapolates n tensors per point (n_points x 6 n to n_nodes x 6 n), which takes less time than one by one. In
  /// quadratic elements the mean stress is taken from its linear fit, see fit_mean_stress.
  void tensors_to_nodes(std::span<const double> point_values, std::span<double> node_values) const;
  /// Volume-weighted mean of point values (n_points x width) per element (n_elements x width).
  void to_elements(std::span<const double> point_values, int width, std::span<double> element_values) const;

 private:
  Discretization() = default;
  void append(const mesh::Mesh& mesh);
  /// Element means, n_elements x width; empty if no element is reconstructed.
  std::vector<double> reconstruction_means(std::span<const double> point_values, int width) const;
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::MatrixXd reconstructed(const ElementBlock& block, std::size_t e, std::span<const double> means,
                                const Eigen::Ref<const Rows>& at_points) const;
  bool has_plane_stress() const { return section_.analysis == settings::Analysis::plane_stress; }
  const ElementBlock& block_of(std::size_t element) const;
  std::span<const std::int64_t> coupled_nodes(std::size_t element) const;
  /// Entries (element, local node) are numbered block by block, element by element.
  std::size_t element_of_entry(std::size_t entry) const;
  template <typename Moduli>
  linalg::SparseMatrix assemble(const Moduli& moduli) const;
  /// forces += the sums at the nodes. @param element_forces  3 per (element, local node)
  void gather(std::span<const double> element_forces, std::span<double> forces) const;
  /// Means at the nodes of the element values. @param values  values(block, element) gives n_nodes x width
  template <typename Values>
  void average_at_nodes(std::size_t width, std::span<double> node_values, const Values& values) const;

  std::vector<std::shared_ptr<const ElementBlock>> blocks_;
  std::shared_ptr<const NodeEntries> entries_;
  std::shared_ptr<const LinearReconstruction> reconstruction_;
  std::size_t n_nodes_ = 0, n_elements_ = 0, n_points_ = 0, n_inner_ = 0;
  mesh::Section section_;
  std::vector<Vector3> nodes_;
  std::vector<Vector3> coordinates_;
  std::vector<double> weights_;
  std::size_t n_entries_ = 0;  // (element, local node)
};

}  // namespace creepcontact::mechanics
