#pragma once
/// One elastic body with its supports and loads: K u = F(t) + integral B^T H (eps_c + eps_th).

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
#include "creepcontact/mechanics/temperature_field.hpp"

namespace creepcontact::mechanics {

/// Immutable once its loads are added: any number of threads may use one body. Movable; what the accessors refer to
/// stays where it is.
class Body {
 public:
  /// @param temperature  nullopt where none is given (thermal strain then zero, T = reference)
  /// @throws ModelError if an element is inverted, supports contradict each other, or the elastic constants are not
  ///         admissible
  Body(std::string name, mesh::Mesh mesh, material::Material material, std::vector<Support> supports,
       std::optional<TemperatureField> temperature);
  ~Body();
  Body(Body&&) noexcept;
  Body& operator=(Body&&) noexcept;

  /// While the model is built. A load on the volume refers to discretization() of this body.
  /// @throws ModelError if its forces at t = 0 are not finite
  void add_load(std::unique_ptr<const Load> load);

  const std::string& name() const;
  const mesh::Mesh& mesh() const;
  const material::Material& material() const;
  const Discretization& discretization() const;
  const Constraints& constraints() const;
  const std::vector<Support>& supports() const;

  /// Pieces of the mesh that share no faces; more than one is seldom meant.
  std::size_t n_parts() const;
  /// What the supports leave free: contact must hold it, or nothing may load it.
  const std::vector<FreeMotion>& free_motions() const;
  /// Free unknowns that are fixed in place of the free motions, one per motion; their displacement is that of the
  /// motions alone (add_free_motions), and they carry no force if all forces on the body are in equilibrium.
  const std::vector<std::int64_t>& pins() const;
  /// Sets the entries of a right-hand side at the pins to zero.
  void clear_pins(std::span<double> right_hand_side) const;
  /// u += sum of amplitudes x free motions (3 n_nodes)
  void add_free_motions(std::span<const double> amplitudes, std::span<double> displacement) const;

  /// Temperature, moduli, thermal strain, loads and prescribed displacements at time t.
  /// @throws ModelError if one of them is not finite, or the elastic constants are not admissible
  BodyConditions at(double t) const;
  /// The same in place: what does not change in time, or is of this time already, is not evaluated again.
  /// @param conditions  of this body, or new
  void update(double t, BodyConditions& conditions) const;
  /// The elastic constants follow a temperature that changes in time.
  bool stiffness_changes() const;

  /// Adds the work of the external forces on the free motions, one entry per motion. The nodal forces of thermal and
  /// creep strains and of prescribed displacements are in equilibrium with themselves: their sums would be round-off,
  /// which may exceed the loads where the material is stiff and almost incompressible.
  /// @returns sum of the absolute forces, to measure the work by
  double external_resultant(const BodyConditions& at, std::span<double> resultant) const;
  /// right_hand_side (n_free) = T^T (F(t) + integral B^T H (creep + thermal strain) - K prescribed(t))
  /// Cost: one element loop; no allocation.
  void right_hand_side(const BodyConditions& at, CreepStrainView creep, std::span<double> right_hand_side) const;
  /// T^T integral B^T H v alone: no loads, no prescribed values. @param elastic  moduli H
  void initial_strain_force(const ElasticState& elastic, CreepStrainView strain,
                            std::span<double> right_hand_side) const;
  /// T^T (F(t) - integral B^T stress): what the stress of a displacement leaves of right_hand_side(). Cost: one element
  /// loop.
  void residual(const BodyConditions& at, std::span<const double> stress, std::span<double> residual) const;
  /// Nodal residual integral B^T sigma - F(t) (3 n_nodes): reactions at held nodes, contact forces at contact nodes.
  void residual_forces(const BodyConditions& at, std::span<const double> stress, std::span<double> forces) const;

  /// Lower triangle over all unknowns (3 n_nodes), of these conditions. Cost: assembly.
  linalg::SparseMatrix full_stiffness(const BodyConditions& at) const;
  /// Of a lower triangle over all unknowns that over the free ones, the pins' rows and columns emptied but for the
  /// diagonal.
  linalg::SparseMatrix on_free_unknowns(const linalg::SparseMatrix& full) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace creepcontact::mechanics
