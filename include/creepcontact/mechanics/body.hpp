#pragma once
/// One elastic body with its supports and loads: K u = F(t) + integral B^T H (creep strain + thermal strain).
/// An initial stress is a constant part of the thermal strain.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/linalg/stiffness_solver.hpp"
#include "creepcontact/material/material.hpp"
#include "creepcontact/mechanics/body_conditions.hpp"
#include "creepcontact/mechanics/constraints.hpp"
#include "creepcontact/mechanics/discretization.hpp"
#include "creepcontact/mechanics/free_motions.hpp"
#include "creepcontact/mechanics/loads.hpp"
#include "creepcontact/mechanics/material_axes.hpp"
#include "creepcontact/mechanics/stress_field.hpp"
#include "creepcontact/mechanics/temperature_field.hpp"

namespace creepcontact::mechanics {

/// Immutable once all loads are added: any number of threads may then use one body. Movable; references returned by the
/// accessors stay valid after a move.
class Body {
 public:
  /// @param temperature  nullopt: no thermal strain, material at its reference temperature
  /// @param axes  of the material; nullopt: those of the coordinates
  /// @param initial_stress  of the undeformed body at its reference temperature, before loads act; empty: none
  /// @throws ModelError if an element is inverted, supports contradict each other, the elastic constants at t = 0 are
  /// not admissible, or the mesh has no volume elements
  Body(std::string name, mesh::Mesh mesh, material::Material material, std::vector<Support> supports,
       std::optional<TemperatureField> temperature, const NodeLinks& links = {},
       std::optional<MaterialAxes> axes = std::nullopt, StressField initial_stress = {});
  ~Body();
  Body(Body&&) noexcept;
  Body& operator=(Body&&) noexcept;

  /// This body as one of several processes has it: all nodes and constraints, but only some of the elements and loads.
  /// What it computes by element loops (stiffness, right-hand sides, residuals) are parts of sums over the processes.
  /// Precondition: this body outlives the part
  /// @param elements  ascending; may be empty
  /// @param loaded_nodes  one mark per node: whose nodal forces are in this part
  Body part(std::span<const std::size_t> elements, const std::vector<char>& loaded_nodes) const;
  /// The elements of a part, numbered as in the whole body; else nullopt.
  const std::optional<std::vector<std::size_t>>& own_elements() const;

  /// Adds a load; only while the model is built. A volume load refers to discretization() of this body.
  /// @throws ModelError if its forces at t = 0 are not finite; the body is then unchanged
  void add_load(std::unique_ptr<const Load> load);

  const std::string& name() const;
  const mesh::Mesh& mesh() const;
  const material::Material& material() const;
  /// Material axes at the points, columns of orthonormal matrices: one for all points, or n_points.
  std::span<const Matrix3> material_axes() const;
  /// The strain that the initial stress makes part of the thermal strain, n_points x 6: minus its elastic strain at the
  /// reference temperature. Empty: none.
  std::span<const double> initial_strain() const;
  const Discretization& discretization() const;
  const Constraints& constraints() const;
  const std::vector<Support>& supports() const;

  /// Number of pieces of the mesh that share no faces; more than one is rarely intended.
  std::size_t n_parts() const;
  /// Motions without strain that the supports leave free. Contact must hold them, or nothing may load them.
  const std::vector<FreeMotion>& free_motions() const;
  /// Fixing dofs: free dofs that are fixed instead of the rigid-body modes, one per motion. They move with those
  /// motions only (add_free_motions), and carry no force if all forces on the body are in equilibrium.
  const std::vector<std::int64_t>& fixing_dofs() const;
  /// Sets the entries of a right-hand side (n_free) at the fixing dofs to zero.
  void clear_fixing_dofs(std::span<double> right_hand_side) const;
  /// u += sum of amplitudes x rigid-body modes (3 n_nodes)
  void add_free_motions(std::span<const double> amplitudes, std::span<double> displacement) const;

  /// Temperatures of the nodes of its elements at time t; empty without a field. Cost: a search per node.
  std::vector<double> temperature_at_nodes(double t) const;
  /// Temperature, moduli, thermal strain, loads and prescribed displacements at time t.
  /// @throws ModelError if one of them is not finite, or the elastic constants are not admissible
  BodyConditions at(double t) const;
  /// Updates conditions to those at time t. Skips what is constant in time or was evaluated for this time already.
  /// @param conditions  made by this body, or new
  /// @param temperature  at the points, if it belongs to the state of a run; empty: that of the field
  void update(double t, BodyConditions& conditions, std::span<const double> temperature = {}) const;
  /// True if the elastic constants depend on a temperature that changes in time.
  bool stiffness_changes() const;

  /// resultant += work of the external forces on the rigid-body modes, one entry per motion. Creep and thermal strains
  /// and prescribed displacements are left out: their nodal forces are in equilibrium, so their work is only round-off.
  /// In a stiff and almost incompressible material it may exceed the work of the loads.
  /// @returns the sum of the absolute forces, the scale of the work; 0 without rigid-body modes
  double external_resultant(const BodyConditions& at, std::span<double> resultant) const;
  /// right_hand_side (n_free) = T^T (F(t) + integral B^T H (creep + thermal strain) - K prescribed(t))
  /// Cost: one element loop; no allocation.
  void right_hand_side(const BodyConditions& at, CreepStrainView creep, std::span<double> right_hand_side) const;
  /// right_hand_side (n_free) = T^T integral B^T H strain, without loads and prescribed displacements.
  /// @param elastic  moduli H
  void initial_strain_force(const ElasticState& elastic, CreepStrainView strain,
                            std::span<double> right_hand_side) const;
  /// residual (n_free) = T^T (F - integral B^T stress), the remainder of right_hand_side() for the stress of some
  /// displacement. Cost: one element loop.
  /// @param external  F, 3 n_nodes, as BodyConditions::external_forces(); empty: no loads
  void residual(std::span<const double> external, std::span<const double> stress, std::span<double> residual) const;
  /// forces (3 n_nodes) = integral B^T stress - F(t): reactions at supported nodes, contact forces at contact nodes.
  void residual_forces(const BodyConditions& at, std::span<const double> stress, std::span<double> forces) const;

  /// The parts of all loads that act beyond a plane through this body.
  std::vector<PointForces> loads_beyond(const Cut& cut) const;

  /// Stiffness on all dofs (3 n_nodes) for these conditions, lower triangle. Cost: assembly.
  linalg::SparseMatrix full_stiffness(const BodyConditions& at) const;
  /// Reduces a lower triangle on all dofs to the free ones. Rows and columns of the fixing dofs are zero off the
  /// diagonal.
  linalg::SparseMatrix on_free_unknowns(const linalg::SparseMatrix& full) const;
  /// What on_free_unknowns(full_stiffness(at)) is computed from. Cost: far below that of an assembly.
  linalg::MatrixInputs stiffness_inputs(const BodyConditions& at) const;

 private:
  struct Impl;
  explicit Body(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace creepcontact::mechanics
