#pragma once
/// Integration-point geometry of a body and the element loops on it: strain, stress, nodal forces, stiffness.
/// Displacements and nodal forces are 3 n_nodes (node by node); stresses and strains n_points x 6 in Mandel order.

#include <memory>
#include <span>
#include <vector>

#include "creepcontact/linalg/stiffness_solver.hpp"
#include "creepcontact/material/material.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mechanics {

using material::Moduli;

class ElementBlock;          // the elements of one type (implementation)
class LinearReconstruction;  // gradients of element means (implementation)
class NodeEntries;           // which element forces belong to a node (implementation)

/// Creep strain inside a state vector: point p's six components start at data[p * stride]. Empty data: no creep strain.
struct CreepStrainView {
  std::span<const double> data = {};
  std::size_t stride = 6;
  bool empty() const { return data.empty(); }
  tensor::ConstMap at(std::size_t point) const { return tensor::ConstMap(&data[stride * point]); }
};

/// Isotropic elastic constants: one for all points, or one per point.
/// Thermal strain (isotropic, one number per point) may be empty, and so may the forces on the inner displacements
/// (3 n_inner), which are zero then.
struct ElasticState {
  std::span<const Moduli> moduli;
  std::span<const double> thermal_strain = {};
  std::span<const double> inner_force = {};
  const Moduli& at(std::size_t point) const { return moduli[moduli.size() == 1 ? 0 : point]; }
};

/// Where creep is large, strain is almost incompressible. So that elements follow it (no locking), the volumetric part
/// of the elastic strain, total less creep and thermal strain, is projected on the constant in hex8 and wedge6 (B-bar,
/// Hughes 1980), on the linear functions of the place in quadratic elements (in hex20 as far as they are distorted).
/// tet10 and wedge15 have an inner displacement besides (fem/bubble.hpp), which is eliminated element by element: a
/// displacement u stands for the nodal one, and stress and strain contain the inner one in equilibrium with it.
///
/// The loops run on all cores; results are bitwise the same for any number of threads. Immutable.
class Discretization {
 public:
  /// Takes the volume cells of the mesh, block by block; cells of lower dimension are ignored.
  /// @throws ModelError if an element is inverted (Jacobian <= 0), naming it and the place
  explicit Discretization(const mesh::Mesh& mesh);

  std::size_t n_nodes() const;
  std::size_t n_elements() const;
  std::size_t n_points() const;
  /// Inner displacements, one per tet10 and wedge15.
  std::size_t n_inner() const;
  std::span<const Vector3> point_coordinates() const;
  /// Volume that belongs to a point.
  std::span<const double> weights() const;
  /// Points of an element are contiguous: element e owns points [first_point(e), first_point(e+1)).
  std::size_t first_point(std::size_t element) const;
  std::span<const std::int64_t> element_nodes(std::size_t element) const;
  mesh::CellType element_type(std::size_t element) const;

  /// sigma = H (B u - creep strain - thermal strain). @param stress n_points x 6
  void stress(std::span<const double> u, const ElasticState& elastic, CreepStrainView creep,
              std::span<double> stress) const;
  /// forces += integral B^T stress, for stress in equilibrium with the forces on the inner displacements
  void add_internal_force(std::span<const double> stress, std::span<double> forces) const;
  /// forces += integral B^T H (creep strain + thermal strain)
  void add_initial_strain_force(const ElasticState& elastic, CreepStrainView creep, std::span<double> forces) const;
  /// Strain B u where stress is D strain - initial stress: the inner displacement is in equilibrium with that.
  /// @param moduli  D, symmetric, one per point @param strain  n_points x 6
  void tangent_strain(std::span<const double> u, std::span<const Matrix6> moduli,
                      std::span<const double> initial_stress, std::span<double> strain) const;
  /// forces += those that the initial stress exerts on fixed nodes, integral B^T initial stress but for what the inner
  /// displacements take
  void add_initial_stress_force(std::span<const Matrix6> moduli, std::span<const double> initial_stress,
                                std::span<double> forces) const;
  /// forces += integral N^T b, b a force per volume at every point (n_points). @param forces  3 (n_nodes + n_inner):
  /// those on the inner displacements come last, ElasticState takes them
  void add_body_force(std::span<const Vector3> force_density, std::span<double> forces) const;

  /// True if fit_mean_stress() changes anything: the body has linear, hex20 or tet10 elements.
  bool fits_mean_stress() const;
  /// Replaces the mean stress at the points of hex20 elements by its fit by a linear function of the place, element by
  /// element, and that of linear elements and tet10 by the mean of its values at their corners, with the gradient of
  /// the element means around. What this takes away (checkerboards of distorted meshes, gradients in flat tetrahedra)
  /// balances nodal forces, but does not approximate the mean stress: fit it where the mean or a principal stress is
  /// evaluated, not for add_internal_force(). Linear fields do not change. @param stress  n_points x 6
  void fit_mean_stress(std::span<double> stress) const;

  /// Stiffness over all 3 n_nodes dofs, lower triangle.
  linalg::SparseMatrix stiffness(const ElasticState& elastic) const;
  /// integral B^T D B for symmetric moduli D of any kind, one a point; the same pattern.
  linalg::SparseMatrix stiffness(std::span<const Matrix6> moduli) const;

  /// Point values (n_points x width) to nodes (n_nodes x width): the mean, weighted by volume, of what the elements of
  /// a node say there. Quadratic elements extrapolate from their points by least squares, linear ones take their mean
  /// and the gradient of the means of their neighbours. Linear fields are exact. Cost: some 100 operations per
  /// neighbour.
  void to_nodes(std::span<const double> point_values, int width, std::span<double> node_values) const;
  /// The same for tensors (n_points x 6 to n_nodes x 6), the mean stress of quadratic elements by its linear function
  /// in the element (see fit_mean_stress).
  void tensors_to_nodes(std::span<const double> point_values, std::span<double> node_values) const;
  /// Values at points as means over each element (n_elements x width), volume weighted.
  void to_elements(std::span<const double> point_values, int width, std::span<double> element_values) const;

 private:
  /// Of the elements, n_elements x width; empty where nothing is reconstructed.
  std::vector<double> reconstruction_means(std::span<const double> point_values, int width) const;
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::MatrixXd reconstructed(const ElementBlock& block, std::size_t e, std::span<const double> means,
                                const Eigen::Ref<const Rows>& at_points) const;
  const ElementBlock& block_of(std::size_t element) const;
  /// Entries are numbered block by block, element by element.
  std::size_t element_of_entry(std::size_t entry) const;
  template <typename Moduli>
  linalg::SparseMatrix assemble(const Moduli& moduli) const;
  /// forces += the sums at the nodes. @param element_forces  3 per (element, local node)
  void gather(std::span<const double> element_forces, std::span<double> forces) const;
  /// Means at the nodes of what the elements say. @param values  of (block, element) gives n_nodes x width
  template <typename Values>
  void average_at_nodes(std::size_t width, std::span<double> node_values, const Values& values) const;

  std::vector<std::shared_ptr<const ElementBlock>> blocks_;
  std::shared_ptr<const NodeEntries> entries_;
  std::shared_ptr<const LinearReconstruction> reconstruction_;
  std::size_t n_nodes_ = 0, n_elements_ = 0, n_points_ = 0, n_inner_ = 0;
  std::vector<Vector3> nodes_;
  std::vector<Vector3> coordinates_;
  std::vector<double> weights_;
  std::size_t n_entries_ = 0;  // (element, local node)
};

}  // namespace creepcontact::mechanics
