#pragma once
/// One elastic body with its supports, loads and factored stiffness: K u = F(t) + integral B^T H (eps_c + eps_th).

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "creepcontact/linalg/supernodal_cholesky.hpp"
#include "creepcontact/material/material.hpp"
#include "creepcontact/mechanics/constraints.hpp"
#include "creepcontact/mechanics/discretization.hpp"
#include "creepcontact/mechanics/free_motions.hpp"
#include "creepcontact/mechanics/loads.hpp"
#include "creepcontact/mechanics/temperature_field.hpp"

namespace creepcontact::mechanics {

/// Movable; what the accessors refer to stays where it is. The functions that compute forces share buffers: not safe
/// for two threads on one body, but different bodies may be used side by side.
class Body {
 public:
  /// The time is 0 until set_time() is called.
  /// @param temperature  nullopt where none is given (thermal strain then zero, T = reference)
  /// @throws ModelError if an element is inverted, supports contradict each other, or the elastic constants are not
  ///         admissible
  Body(std::string name, mesh::Mesh mesh, material::Material material, std::vector<Support> supports,
       std::optional<TemperatureField> temperature);
  ~Body();
  Body(Body&&) noexcept;
  Body& operator=(Body&&) noexcept;

  /// A load on the volume refers to discretization() of this body.
  void add_load(std::unique_ptr<Load> load);

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
  /// Free unknowns that are fixed in place of the free motions, one a motion; their displacement is that of the motions
  /// alone (add_free_motions), and they carry no force if all forces on the body are in equilibrium.
  const std::vector<std::int64_t>& pins() const;
  /// Adds the work of the external forces at the set time on the free motions, one entry per motion. The nodal forces
  /// of thermal and creep strains and of prescribed displacements are in equilibrium with themselves: their sums would
  /// be round-off, which may exceed the loads where the material is stiff and almost incompressible.
  /// @returns sum of the absolute forces, to measure the work by
  double external_resultant(std::span<double> resultant) const;
  /// Sets the entries of a right-hand side at the pins to zero.
  void clear_pins(std::span<double> right_hand_side) const;
  /// u += sum of amplitudes x free motions (3 n_nodes)
  void add_free_motions(std::span<const double> amplitudes, std::span<double> displacement) const;

  /// Orders, analyses and factors the stiffness of the free unknowns at the set time, the pins fixed.
  /// @param trailing  free unknowns to be eliminated last (those of the contact surfaces)
  /// @throws ModelError naming the body and the place if the stiffness is singular
  void factorize(const std::vector<std::int64_t>& trailing);
  /// The two halves of it. Between them the sizes of factor() are known, and nothing of them is taken.
  void analyze(const std::vector<std::int64_t>& trailing);
  void factorize();
  /// The elastic constants follow a temperature that changes in time: those of the factor are then those of
  /// factor_time() alone.
  bool stiffness_changes() const;
  /// Factors the stiffness of the set time, in the order and with the pattern found before. @throws as factorize
  void refactorize();
  double factor_time() const;
  /// Least and largest ratio of the bulk and shear moduli at the set time to those of the factor, over all points: the
  /// eigenvalues of K0^-1 K(t) lie between them. {1, 1} if the stiffness does not change.
  std::pair<double, double> stiffness_ratio() const;
  /// As factorize, but the analysis only: bytes of the factor, and of the work space of a factorisation, for `check`.
  std::int64_t estimate_factor_bytes() const;
  /// That of the set time: lower triangle over the free unknowns, the pins' rows and columns emptied but for the
  /// diagonal. Cost: assembly.
  linalg::SparseMatrix stiffness() const;
  /// The same with symmetric moduli of any kind, one a point, in place of the elastic ones.
  linalg::SparseMatrix stiffness(std::span<const Matrix6> moduli) const;
  /// Valid after factorize(); its sizes after analyze().
  linalg::SupernodalCholesky& factor();

  /// Temperature at the integration points at time t; empty if none is given. Valid until the next call.
  std::span<const double> temperature(double t);
  /// Sets the time of loads, supports and temperature for the calls below (no work if unchanged).
  void set_time(double t);
  /// Elastic constants and thermal strain at the set time.
  ElasticState elastic() const;
  /// Cost: one element loop; no allocation.
  /// right_hand_side (n_free) = T^T (F(t) + integral B^T H (creep + thermal strain) - K prescribed(t))
  void right_hand_side(CreepStrainView creep, std::span<double> right_hand_side) const;
  /// T^T integral B^T H0 v alone (Jacobian products), H0 that of the factor: no loads, no prescribed values.
  void initial_strain_force(CreepStrainView strain, std::span<double> right_hand_side) const;
  /// Elastic constants of the factor, without thermal strain.
  ElasticState factored() const;
  /// What the stress of a displacement leaves of right_hand_side(): T^T (F(t) - integral B^T stress). Cost: one element
  /// loop. @param free  the free unknowns of that displacement
  void imbalance(std::span<const double> stress, std::span<const double> free, std::span<double> right_hand_side) const;
  std::span<const double> prescribed() const;  ///< 3 n_nodes at the set time
  /// External forces F(t) at the set time, 3 n_nodes.
  std::span<const double> external_forces() const;
  /// Nodal residual integral B^T sigma - F(t) (3 n_nodes): reactions at held nodes, contact forces at contact nodes.
  void residual_forces(std::span<const double> stress, std::span<double> forces) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace creepcontact::mechanics
