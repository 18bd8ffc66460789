#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "body_impl.hpp"
#include "creepcontact/base/error.hpp"

namespace creepcontact::mechanics {

void Body::Impl::require_finite(std::span<const double> values, double t) const {
  if (Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())).allFinite()) return;
  throw ModelError(fmt::format(
      "body '{}': its loads, supports or temperature give no finite number at t = {:.6g}; look for divisions "
      "by zero and roots or logarithms of negative numbers in their expressions",
      name, t));
}

void Body::Impl::set_time(double t) {
  if (time == t) return;
  time.reset();  // stays unset if something below throws
  moduli = thermal.moduli(material, t);
  thermal_strain = thermal.strain(material, t);
  std::fill(external.begin(), external.end(), 0.0);
  for (const auto& load : loads) load->add(t, external);
  require_finite(external, t);
  require_finite(thermal_strain, t);
  const auto end_of_nodes = external.begin() + static_cast<std::ptrdiff_t>(known.size());
  inner_load = std::any_of(end_of_nodes, external.end(), [](double force) { return force != 0; });
  known.assign(external.begin(), end_of_nodes);
  if (constraints.prescribed(t, prescribed)) {
    discretization.stress(prescribed, isothermal(), {}, stress);
    std::fill(forces.begin(), forces.end(), 0.0);
    discretization.add_internal_force(stress, forces);
    for (std::size_t i = 0; i < known.size(); ++i) known[i] -= forces[i];
  }
  require_finite(known, t);
  time = t;
}

Body::Body(std::string name, mesh::Mesh mesh, material::Material material, std::vector<Support> supports,
           std::optional<TemperatureField> temperature)
    : impl_(std::make_unique<Impl>(std::move(name), std::move(mesh), std::move(material), std::move(supports),
                                   std::move(temperature))) {
  impl_->set_time(0.0);
  impl_->factored_moduli.assign(impl_->moduli.begin(), impl_->moduli.end());
}
Body::~Body() = default;
Body::Body(Body&&) noexcept = default;
Body& Body::operator=(Body&&) noexcept = default;

void Body::add_load(std::unique_ptr<Load> load) {
  Impl& body = *impl_;
  const double t = body.time.value_or(0.0);
  std::vector<double> own(body.external.size(), 0.0);
  load->add(t, own);
  body.require_finite(own, t);
  body.loads.push_back(std::move(load));
  body.time.reset();
  body.set_time(t);
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

double Body::external_resultant(std::span<double> resultant) const {
  if (impl_->pins.empty()) return 0;
  const std::span<const double> forces = external_forces();
  const Eigen::Map<const Eigen::VectorXd> external(forces.data(), static_cast<Eigen::Index>(forces.size()));
  for (std::size_t i = 0; i < impl_->pins.size(); ++i)
    resultant[i] += impl_->free_motions[i].displacement.dot(external);
  return external.cwiseAbs().sum();
}

void Body::clear_pins(std::span<double> right_hand_side) const {
  for (const std::int64_t pin : impl_->pins) right_hand_side[static_cast<std::size_t>(pin)] = 0;
}

void Body::add_free_motions(std::span<const double> amplitudes, std::span<double> displacement) const {
  Eigen::Map<Eigen::VectorXd> u(displacement.data(), static_cast<Eigen::Index>(displacement.size()));
  for (std::size_t i = 0; i < impl_->pins.size(); ++i) u += amplitudes[i] * impl_->free_motions[i].displacement;
}

std::span<const double> Body::temperature(double t) {
  return impl_->thermal.temperature(t);
}
void Body::set_time(double t) {
  impl_->set_time(t);
}
ElasticState Body::elastic() const {
  return impl_->elastic();
}

void Body::right_hand_side(CreepStrainView creep, std::span<double> right_hand_side) const {
  impl_->forces = impl_->known;
  const ElasticState elastic = impl_->elastic();
  if (creep.data != nullptr || !elastic.thermal_strain.empty() || !elastic.inner_force.empty())
    impl_->discretization.add_initial_strain_force(elastic, creep, impl_->forces);
  impl_->constraints.restrict_to_free(impl_->forces, right_hand_side);
}

void Body::initial_strain_force(CreepStrainView strain, std::span<double> right_hand_side) const {
  std::fill(impl_->forces.begin(), impl_->forces.end(), 0.0);
  impl_->discretization.add_initial_strain_force(factored(), strain, impl_->forces);
  impl_->constraints.restrict_to_free(impl_->forces, right_hand_side);
}

void Body::imbalance(std::span<const double> stress, std::span<const double> free,
                     std::span<double> right_hand_side) const {
  std::fill(impl_->forces.begin(), impl_->forces.end(), 0.0);
  impl_->discretization.add_internal_force(stress, impl_->forces);
  std::ranges::transform(external_forces(), impl_->forces, impl_->forces.begin(), std::minus<>());
  impl_->constraints.restrict_to_free(impl_->forces, right_hand_side);
  if (!impl_->stabilized) return;
  const auto n = static_cast<Eigen::Index>(free.size());
  Eigen::Map<Eigen::VectorXd>(right_hand_side.data(), n) -=
      impl_->hourglass.selfadjointView<Eigen::Lower>() * Eigen::Map<const Eigen::VectorXd>(free.data(), n);
}

std::span<const double> Body::prescribed() const {
  return impl_->prescribed;
}
std::span<const double> Body::external_forces() const {
  return std::span(impl_->external).first(impl_->known.size());
}

void Body::residual_forces(std::span<const double> stress, std::span<double> forces) const {
  std::ranges::transform(external_forces(), forces.begin(), std::negate<>());
  impl_->discretization.add_internal_force(stress, forces);
}

}  // namespace creepcontact::mechanics
