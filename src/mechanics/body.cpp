#include "creepcontact/mechanics/body.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "hourglass.hpp"
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
        moduli(thermal.moduli(material)),
        external(3 * mesh.nodes.size()),
        prescribed(3 * mesh.nodes.size()),
        known(3 * mesh.nodes.size()),
        forces(3 * mesh.nodes.size()),
        stress(constraints.has_nonzero_values() ? 6 * discretization.n_points() : 0) {}

  ElasticState isothermal() const { return {moduli, {}}; }
  linalg::SparseMatrix free_stiffness() const;
  linalg::SparseMatrix on_free_unknowns(const linalg::SparseMatrix& all) const;
  bool has_hex20() const;
  void set_time(double t);
  /// @throws ModelError if a force is infinite or not a number
  void require_finite(const std::vector<double>& values, double t) const;
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
  std::vector<Moduli> moduli;
  std::vector<std::unique_ptr<Load>> loads;
  bool stabilized = false;  // hourglass modes are held
  std::optional<linalg::SupernodalCholesky> factor;

  // At the set time: known = external + integral B^T H thermal strain - K prescribed.
  std::optional<double> time;
  std::span<const double> thermal_strain;
  std::vector<double> external, prescribed, known;
  mutable std::vector<double> forces;  // work space, 3 n_nodes
  std::vector<double> stress;          // of the prescribed displacement
};

linalg::SparseMatrix Body::Impl::free_stiffness() const {
  linalg::SparseMatrix all = discretization.stiffness(isothermal());
  if (stabilized) add_hourglass_stiffness(mesh, all.diagonal(), all);
  return on_free_unknowns(all);
}

/// The pins' rows and columns are emptied but for the diagonal.
linalg::SparseMatrix Body::Impl::on_free_unknowns(const linalg::SparseMatrix& all) const {
  linalg::SparseMatrix stiffness = constraints.reduce(all);
  if (pins.empty()) return stiffness;
  std::vector<char> pinned(static_cast<std::size_t>(constraints.n_free()), 0);
  for (const std::int64_t pin : pins) pinned[static_cast<std::size_t>(pin)] = 1;
  for (std::int64_t column = 0; column < stiffness.outerSize(); ++column)
    for (linalg::SparseMatrix::InnerIterator it(stiffness, column); it; ++it)
      if (it.row() != column &&
          (pinned[static_cast<std::size_t>(it.row())] || pinned[static_cast<std::size_t>(column)]))
        it.valueRef() = 0;
  return stiffness;
}

bool Body::Impl::has_hex20() const {
  return std::any_of(mesh.blocks.begin(), mesh.blocks.end(), [](const mesh::CellBlock& block) {
    return block.type == mesh::CellType::hex20 && block.size() > 0;
  });
}

void Body::Impl::require_finite(const std::vector<double>& values, double t) const {
  if (Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())).allFinite()) return;
  throw ModelError(fmt::format(
      "body '{}': its loads, supports or temperature give no finite number at t = {:.6g}; look for divisions "
      "by zero and roots or logarithms of negative numbers in their expressions",
      name, t));
}

void Body::Impl::set_time(double t) {
  if (time == t) return;
  time.reset();  // stays unset if something below throws
  thermal_strain = thermal.strain(material, t);
  std::fill(external.begin(), external.end(), 0.0);
  for (const auto& load : loads) load->add(t, external);
  known = external;
  if (!thermal_strain.empty()) discretization.add_initial_strain_force({moduli, thermal_strain}, {}, known);
  if (constraints.prescribed(t, prescribed)) {
    discretization.stress(prescribed, isothermal(), {}, stress);
    std::fill(forces.begin(), forces.end(), 0.0);
    discretization.add_internal_force(stress, forces);
    for (std::size_t i = 0; i < known.size(); ++i) known[i] -= forces[i];
  }
  require_finite(known, t);
  time = t;
}

void Body::Impl::report_singular(const linalg::SingularMatrix& error) const {
  const auto& node_of_free = constraints.node_of_free();
  const bool located = error.row >= 0 && error.row < constraints.n_free();
  std::string place;
  if (located) {
    const Vector3& x = mesh.nodes[static_cast<std::size_t>(node_of_free[static_cast<std::size_t>(error.row)])];
    place = fmt::format(" at the node ({:.6g}, {:.6g}, {:.6g})", x[0], x[1], x[2]);
  }
  throw ModelError(
      fmt::format("body '{}': the stiffness is singular{} (reciprocal condition {:.2g}); a part of the body hangs on "
                  "too few nodes, or the elements there are too thin or the material almost incompressible",
                  name, place, error.rcond));
}

Body::Body(std::string name, mesh::Mesh mesh, material::Material material, std::vector<Support> supports,
           std::optional<TemperatureField> temperature)
    : impl_(std::make_unique<Impl>(std::move(name), std::move(mesh), std::move(material), std::move(supports),
                                   std::move(temperature))) {
  impl_->set_time(0.0);
}
Body::~Body() = default;
Body::Body(Body&&) noexcept = default;
Body& Body::operator=(Body&&) noexcept = default;

void Body::add_load(std::unique_ptr<Load> load) {
  Impl& body = *impl_;
  std::fill(body.forces.begin(), body.forces.end(), 0.0);
  load->add(body.time.value_or(0.0), body.forces);
  body.require_finite(body.forces, body.time.value_or(0.0));
  for (std::size_t i = 0; i < body.forces.size(); ++i) {
    body.external[i] += body.forces[i];
    body.known[i] += body.forces[i];
  }
  body.loads.push_back(std::move(load));
}

const std::string& Body::name() const {
  return impl_->name;
}
const mesh::Mesh& Body::mesh() const {
  return impl_->mesh;
}
const material::Material& Body::material() const {
  return impl_->material;
}
const Discretization& Body::discretization() const {
  return impl_->discretization;
}
const Constraints& Body::constraints() const {
  return impl_->constraints;
}
const std::vector<Support>& Body::supports() const {
  return impl_->supports;
}

std::size_t Body::n_parts() const {
  return impl_->parts.size();
}
const std::vector<FreeMotion>& Body::free_motions() const {
  return impl_->free_motions;
}
const std::vector<std::int64_t>& Body::pins() const {
  return impl_->pins;
}

double Body::take_resultant(std::span<double> right_hand_side, std::span<double> resultant) const {
  if (impl_->pins.empty()) return 0;
  // The motions vanish at held directions, so the forces may be taken back to all unknowns.
  impl_->constraints.expand(right_hand_side, {}, impl_->forces);
  const Eigen::Map<const Eigen::VectorXd> forces(impl_->forces.data(), static_cast<Eigen::Index>(impl_->forces.size()));
  for (std::size_t i = 0; i < impl_->pins.size(); ++i) {
    resultant[i] += impl_->free_motions[i].displacement.dot(forces);
    right_hand_side[static_cast<std::size_t>(impl_->pins[i])] = 0;
  }
  return forces.cwiseAbs().sum();
}

void Body::add_free_motions(std::span<const double> amplitudes, std::span<double> displacement) const {
  Eigen::Map<Eigen::VectorXd> u(displacement.data(), static_cast<Eigen::Index>(displacement.size()));
  for (std::size_t i = 0; i < impl_->pins.size(); ++i) u += amplitudes[i] * impl_->free_motions[i].displacement;
}

void Body::factorize(std::vector<std::int64_t> trailing) {
  const linalg::SparseMatrix stiffness = impl_->free_stiffness();
  impl_->factor.emplace(stiffness, impl_->constraints.node_of_free(), trailing);
  try {
    impl_->factor->factorize(stiffness);
    return;
  } catch (const linalg::SingularMatrix& error) {
    impl_->stabilized = impl_->has_hex20();
    if (!impl_->stabilized) impl_->report_singular(error);
  }
  try {
    impl_->factor->factorize(impl_->free_stiffness());
    log::warning(
        "body '{}': hex20 elements stand in single rows, where their reduced integration misses some motions; a "
        "millionth of "
        "their stiffness holds these",
        impl_->name);
  } catch (const linalg::SingularMatrix& error) {
    impl_->factor.reset();
    impl_->report_singular(error);
  }
}

std::int64_t Body::estimate_factor_bytes() const {
  return linalg::SupernodalCholesky(impl_->free_stiffness(), impl_->constraints.node_of_free(), {}).factor_bytes();
}

linalg::SparseMatrix Body::stiffness() const {
  return impl_->free_stiffness();
}

linalg::SparseMatrix Body::stiffness(std::span<const Matrix6> moduli) const {
  linalg::SparseMatrix all = impl_->discretization.stiffness(moduli);
  // The elastic one also here: it stands for no material, and creep does not relax it.
  if (impl_->stabilized)
    add_hourglass_stiffness(impl_->mesh, impl_->discretization.stiffness(impl_->isothermal()).diagonal(), all);
  return impl_->on_free_unknowns(all);
}

linalg::SupernodalCholesky& Body::factor() {
  return *impl_->factor;
}

std::span<const double> Body::temperature(double t) {
  return impl_->thermal.temperature(t);
}
void Body::set_time(double t) {
  impl_->set_time(t);
}
ElasticState Body::elastic() const {
  return {impl_->moduli, impl_->thermal_strain};
}

void Body::right_hand_side(CreepStrainView creep, std::span<double> right_hand_side) const {
  impl_->forces = impl_->known;
  if (creep.data != nullptr) impl_->discretization.add_initial_strain_force(impl_->isothermal(), creep, impl_->forces);
  impl_->constraints.restrict_to_free(impl_->forces, right_hand_side);
}

void Body::initial_strain_force(CreepStrainView strain, std::span<double> right_hand_side) const {
  std::fill(impl_->forces.begin(), impl_->forces.end(), 0.0);
  impl_->discretization.add_initial_strain_force(impl_->isothermal(), strain, impl_->forces);
  impl_->constraints.restrict_to_free(impl_->forces, right_hand_side);
}

std::span<const double> Body::prescribed() const {
  return impl_->prescribed;
}
std::span<const double> Body::external_forces() const {
  return impl_->external;
}

void Body::residual_forces(std::span<const double> stress, std::span<double> forces) const {
  std::transform(impl_->external.begin(), impl_->external.end(), forces.begin(), [](double f) { return -f; });
  impl_->discretization.add_internal_force(stress, forces);
}

}  // namespace creepcontact::mechanics
