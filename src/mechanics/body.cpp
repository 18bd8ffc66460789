#include <algorithm>
#include <array>
#include <functional>

#include "body_impl.hpp"
#include "creepcontact/base/checksum.hpp"

namespace creepcontact::mechanics {
namespace {

/// Work space of the calling thread for nodal forces, zeros.
std::vector<double>& zero_forces(std::size_t n) {
  thread_local std::vector<double> forces;
  forces.assign(n, 0.0);
  return forces;
}

}  // namespace

Body::Body(std::string name, mesh::Mesh mesh, material::Material material, std::vector<Support> supports,
           std::optional<TemperatureField> temperature, const NodeLinks& links, std::optional<MaterialAxes> axes,
           StressField initial_stress)
    : impl_(std::make_unique<Impl>(std::move(name), std::move(mesh), std::move(material), std::move(supports),
                                   std::move(temperature), links, std::move(axes), std::move(initial_stress))) {
  at(0.0);  // throws where something is not admissible
}
Body::~Body() = default;
Body::Body(Body&&) noexcept = default;
Body& Body::operator=(Body&&) noexcept = default;

namespace {

/// What falls to a part of the loads of a body.
class PartOfLoads final : public Load {
 public:
  /// @param inner  those of the part, numbered as in the whole body
  PartOfLoads(std::span<const std::unique_ptr<const Load>> loads, std::size_t n_whole, std::vector<char> loaded_nodes,
              std::vector<std::size_t> inner)
      : loads_(loads), n_whole_(n_whole), loaded_nodes_(std::move(loaded_nodes)), inner_(std::move(inner)) {}

  void add(double t, std::span<double> forces) const override {
    std::vector<double> whole(n_whole_, 0.0);
    for (const auto& load : loads_) load->add(t, whole);
    const std::size_t n_nodes = loaded_nodes_.size();
    for (std::size_t i = 0; i < 3 * n_nodes; ++i)
      if (loaded_nodes_[i / 3] != 0) forces[i] += whole[i];
    for (std::size_t i = 0; i < inner_.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) forces[3 * (n_nodes + i) + k] += whole[3 * (n_nodes + inner_[i]) + k];
  }
  void append_beyond(const Cut& cut, std::vector<PointForces>& parts) const override {
    for (const auto& load : loads_) load->append_beyond(cut, parts);
  }

 private:
  std::span<const std::unique_ptr<const Load>> loads_;
  std::size_t n_whole_;
  std::vector<char> loaded_nodes_;
  std::vector<std::size_t> inner_;
};

}  // namespace

Body::Body(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Body Body::part(std::span<const std::size_t> elements, const std::vector<char>& loaded_nodes) const {
  auto of_part = std::make_unique<Impl>(*impl_, elements);
  if (!impl_->loads.empty()) {
    std::vector<std::size_t> inner;
    for (const std::size_t element : elements)
      if (const auto own = impl_->discretization.inner(element)) inner.push_back(*own);
    of_part->loads.push_back(
        std::make_unique<PartOfLoads>(impl_->loads, 3 * (impl_->mesh.nodes.size() + impl_->discretization.n_inner()),
                                      loaded_nodes, std::move(inner)));
  }
  return Body(std::move(of_part));
}

const std::optional<std::vector<std::size_t>>& Body::own_elements() const {
  return impl_->own_elements;
}

void Body::add_load(std::unique_ptr<const Load> load) {
  impl_->loads.push_back(std::move(load));
  try {
    at(0.0);
  } catch (...) {
    impl_->loads.pop_back();
    throw;
  }
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
std::span<const Matrix3> Body::material_axes() const {
  return impl_->axes;
}
std::span<const double> Body::initial_strain() const {
  return impl_->initial_strain;
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
const std::vector<std::int64_t>& Body::fixing_dofs() const {
  return impl_->fixing_dofs;
}

void Body::clear_fixing_dofs(std::span<double> right_hand_side) const {
  for (const std::int64_t pin : impl_->fixing_dofs) right_hand_side[pin] = 0;
}

void Body::add_free_motions(std::span<const double> amplitudes, std::span<double> displacement) const {
  Eigen::Map<Eigen::VectorXd> u(displacement.data(), displacement.size());
  for (std::size_t i = 0; i < impl_->fixing_dofs.size(); ++i) u += amplitudes[i] * impl_->free_motions[i].displacement;
}

double Body::external_resultant(const BodyConditions& at, std::span<double> resultant) const {
  if (impl_->fixing_dofs.empty()) return 0;
  const std::span<const double> forces = at.external_forces();
  const Eigen::Map<const Eigen::VectorXd> external(forces.data(), forces.size());
  for (std::size_t i = 0; i < impl_->fixing_dofs.size(); ++i)
    resultant[i] += impl_->free_motions[i].displacement.dot(external);
  return external.cwiseAbs().sum();
}

void Body::right_hand_side(const BodyConditions& at, CreepStrainView creep, std::span<double> right_hand_side) const {
  const ElasticState elastic = at.elastic();
  if (creep.empty() && !elastic.has_thermal_strain() && elastic.inner_force.empty())
    return impl_->constraints.restrict_to_free(at.known, right_hand_side);
  std::vector<double>& forces = zero_forces(0);
  forces.assign(at.known.begin(), at.known.end());
  impl_->discretization.add_initial_strain_force(elastic, creep, forces);
  impl_->constraints.restrict_to_free(forces, right_hand_side);
}

void Body::initial_strain_force(const ElasticState& elastic, CreepStrainView strain,
                                std::span<double> right_hand_side) const {
  std::vector<double>& forces = zero_forces(3 * impl_->mesh.nodes.size());
  impl_->discretization.add_initial_strain_force(elastic, strain, forces);
  impl_->constraints.restrict_to_free(forces, right_hand_side);
}

void Body::residual(std::span<const double> external, std::span<const double> stress,
                    std::span<double> residual) const {
  std::vector<double>& forces = zero_forces(3 * impl_->mesh.nodes.size());
  impl_->discretization.add_internal_force(stress, forces);
  if (external.empty())
    std::ranges::transform(forces, forces.begin(), std::negate<>());
  else
    std::ranges::transform(external, forces, forces.begin(), std::minus<>());
  impl_->constraints.restrict_to_free(forces, residual);
}

void Body::residual_forces(const BodyConditions& at, std::span<const double> stress, std::span<double> forces) const {
  std::ranges::transform(at.external_forces(), forces.begin(), std::negate<>());
  impl_->discretization.add_internal_force(stress, forces);
}

std::vector<PointForces> Body::loads_beyond(const Cut& cut) const {
  std::vector<PointForces> parts;
  for (const auto& load : impl_->loads) load->append_beyond(cut, parts);
  return parts;
}

linalg::SparseMatrix Body::full_stiffness(const BodyConditions& at) const {
  return impl_->discretization.stiffness(at.stiffness());
}

linalg::SparseMatrix Body::on_free_unknowns(const linalg::SparseMatrix& full) const {
  linalg::SparseMatrix stiffness = impl_->constraints.reduce(full);
  if (impl_->fixing_dofs.empty()) return stiffness;
  std::vector<char> pinned(impl_->constraints.n_free(), 0);
  for (const std::int64_t pin : impl_->fixing_dofs) pinned[pin] = 1;
  for (std::int64_t column = 0; column < stiffness.outerSize(); ++column)
    for (linalg::SparseMatrix::InnerIterator it(stiffness, column); it; ++it)
      if (it.row() != column && (pinned[it.row()] || pinned[column])) it.valueRef() = 0;
  return stiffness;
}

linalg::MatrixInputs Body::stiffness_inputs(const BodyConditions& at) const {
  Checksum geometry;
  const mesh::Mesh& mesh = impl_->mesh;
  for (const Vector3& node : mesh.nodes) geometry.add(node.data(), 3);
  for (const mesh::CellBlock& block : mesh.blocks) {
    if (!mesh.is_bulk(block.type)) continue;
    geometry.add(&block.type, 1);
    geometry.add(block.connectivity.data(), block.connectivity.size());
  }
  const mesh::Section& section = mesh.section;
  geometry.add(&section.analysis, 1);
  geometry.add(std::array{section.thickness, section.axial_length}.data(), 2);
  geometry.add(&section.project_distorted, 1);
  geometry.add(&mesh.axial_node, 1);
  if (const auto& own = impl_->own_elements) geometry.add(own->data(), own->size());
  impl_->constraints.add_to(geometry);
  geometry.add(impl_->fixing_dofs.data(), impl_->fixing_dofs.size());

  Checksum material;
  const ElasticState elastic = at.stiffness();
  for (const Moduli& moduli : elastic.moduli) material.add(std::array{moduli.lambda, moduli.mu}.data(), 2);
  for (const Matrix6& moduli : elastic.matrices) material.add(moduli.data(), 36);
  return {geometry.value(), material.value()};
}

}  // namespace creepcontact::mechanics
