#pragma once
/// What a body consists of; body.cpp has its forces, body_stiffness.cpp its stiffness.

#include "creepcontact/mechanics/body.hpp"
#include "thermal_state.hpp"

namespace creepcontact::mechanics {

struct Body::Impl {
  Impl(std::string name_in, mesh::Mesh mesh_in, material::Material material_in, std::vector<Support> supports_in,
       std::optional<TemperatureField> temperature)
      : name(std::move(name_in)),
        mesh(std::move(mesh_in)),
        material(std::move(material_in)),
        supports(std::move(supports_in)),
        discretization(mesh),
        constraints(mesh.nodes, supports),
        parts(mesh_parts(mesh)),
        free_motions(mechanics::free_motions(mesh, parts, constraints)),
        pins(determinate_pins(free_motions, constraints)),
        thermal(std::move(temperature), discretization),
        external(3 * (mesh.nodes.size() + discretization.n_inner())),
        prescribed(3 * mesh.nodes.size()),
        known(3 * mesh.nodes.size()),
        forces(3 * mesh.nodes.size()),
        stress(constraints.has_nonzero_values() ? 6 * discretization.n_points() : 0) {}

  ElasticState isothermal() const { return {moduli, {}}; }
  linalg::SparseMatrix free_stiffness() const;
  void stabilize();
  void factorize(const linalg::SparseMatrix& stiffness);
  linalg::SparseMatrix on_free_unknowns(const linalg::SparseMatrix& all) const;
  bool has_hex20() const;
  void set_time(double t);
  /// @throws ModelError if a force is infinite or not a number
  void require_finite(std::span<const double> values, double t) const;
  /// At the set time.
  ElasticState elastic() const {
    return {moduli, thermal_strain, inner_load ? std::span(external).subspan(forces.size()) : std::span<double>{}};
  }
  [[noreturn]] void report_singular(const linalg::SingularMatrix& error) const;

  std::string name;
  mesh::Mesh mesh;
  material::Material material;
  std::vector<Support> supports;
  Discretization discretization;
  Constraints constraints;
  MeshParts parts;
  std::vector<FreeMotion> free_motions;
  std::vector<std::int64_t> pins;
  ThermalState thermal;
  std::vector<std::unique_ptr<Load>> loads;
  std::optional<linalg::SupernodalCholesky> factor;
  linalg::SparseMatrix analyzed;  // the stiffness, from analyze() to factorize()
  std::vector<Moduli> factored_moduli;
  double factor_time = 0;

  // Where hourglass modes are held: the diagonal of the elastic stiffness that measures what holds them, and that
  // itself on the free unknowns. They stay as they are: they stand for no material.
  bool stabilized = false;
  Eigen::VectorXd hourglass_diagonal;
  linalg::SparseMatrix hourglass;

  // At the set time: known = external - K prescribed. The external forces on inner displacements come last.
  bool inner_load = false;  // some of those are not zero
  std::optional<double> time;
  std::span<const Moduli> moduli;
  std::span<const double> thermal_strain;
  std::vector<double> external, prescribed, known;
  mutable std::vector<double> forces;  // work space, 3 n_nodes
  std::vector<double> stress;          // of the prescribed displacement
};

}  // namespace creepcontact::mechanics
