#include "creepcontact/mechanics/body_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "body_impl.hpp"
#include "creepcontact/base/error.hpp"

namespace creepcontact::mechanics {
namespace {

/// The result of `of`, whose errors then name the material.
template <class Of>
auto of_named(const material::Material& material, const Of& of) {
  try {
    return of();
  } catch (const ModelError& error) {
    throw ModelError(fmt::format("material '{}': {}", material.name, error.what()));
  }
}

Moduli moduli_at(const material::Material& material, double temperature) {
  const double young_modulus = of_named(material, [&] { return material.young_modulus({.T = temperature}); });
  const double poisson_ratio = material.poisson_ratio({.T = temperature});
  if (!(young_modulus > 0) || !(poisson_ratio > -1 && poisson_ratio < 0.5)) {
    throw ModelError(
        fmt::format("material '{}' at the temperature {:g}: young_modulus {:g} must be positive and poisson_ratio {:g} "
                    "between -1 and 0.5 (excluded); correct the functions of T",
                    material.name, temperature, young_modulus, poisson_ratio));
  }
  return material::lame(young_modulus, poisson_ratio);
}

/// Elasticity matrices in global axes. @param axes  one for all points, or one per point
std::vector<Matrix6> matrices_at(const material::Material& material, std::span<const Matrix3> axes,
                                 std::span<const double> temperature, std::size_t n_points) {
  std::vector<Matrix6> result;
  result.reserve(n_points);
  const bool uniform = axes.size() == 1 && (temperature.empty() || !material.orthotropy->depends_on_temperature());
  for (std::size_t p = 0; p < n_points; ++p) {
    if (uniform && p > 0) {
      result.push_back(result.front());
      continue;
    }
    const double T = temperature.empty() ? material.reference_temperature : temperature[p];
    const Matrix6 along_axes = of_named(material, [&] { return material.orthotropy->stiffness(T); });
    result.push_back(material::turned(along_axes, axes[axes.size() == 1 ? 0 : p]));
  }
  return result;
}

/// The thermal strain of these temperatures, and the initial strain.
void expand(const material::Material& material, std::span<const Matrix3> axes, std::span<const double> initial_strain,
            BodyConditions& at) {
  const std::size_t n_points = at.temperature.size();
  const auto strains = [&](std::size_t p) {
    return material.thermal_expansion.strains(at.temperature[p], material.reference_temperature);
  };
  if (!material.thermal_expansion.has_axes && initial_strain.empty()) {
    at.thermal_strain.resize(n_points);
    for (std::size_t p = 0; p < n_points; ++p) at.thermal_strain[p] = strains(p)[0];
    return;
  }
  at.thermal_tensors.resize(6 * n_points);
  for (std::size_t p = 0; p < n_points; ++p) {
    const Matrix3& own = axes[axes.size() == 1 ? 0 : p];
    auto strain = tensor::writable(at.thermal_tensors, p);
    strain = tensor::from_matrix(own * strains(p).asDiagonal() * own.transpose());
    if (!initial_strain.empty()) strain += tensor::view(initial_strain, p);
  }
}

bool moduli_depend_on_temperature(const material::Material& material) {
  return material.young_modulus.depends_on_temperature() || material.poisson_ratio.depends_on_temperature();
}

void require_finite(const std::string& body, std::span<const double> values, double t) {
  if (Eigen::Map<const Eigen::VectorXd>(values.data(), values.size()).allFinite()) return;
  throw ModelError(fmt::format(
      "body '{}': its loads, supports, temperature, thermal expansion or initial stress are not finite at t = {:.6g}; "
      "check their expressions "
      "for divisions by zero and for roots or logarithms of negative numbers",
      body, t));
}

}  // namespace

void Body::Impl::set_initial_strain() {
  if (!initial_stress) return;
  const std::size_t n_points = discretization.n_points();
  const std::vector<Moduli> moduli{moduli_at(material, material.reference_temperature)};
  const std::vector<double> reference(n_points, material.reference_temperature);
  std::vector<Matrix6> matrices;
  if (material.orthotropy) matrices = matrices_at(material, axes, reference, n_points);
  const ElasticState elastic{.moduli = moduli, .matrices = matrices};
  initial_strain.resize(6 * n_points);
  for (std::size_t p = 0; p < n_points; ++p)
    tensor::writable(initial_strain, p) =
        -elastic.elastic_strain(p, initial_stress(discretization.point_coordinates()[p]));
}

BodyConditions Body::at(double t) const {
  BodyConditions conditions;
  update(t, conditions);
  return conditions;
}

std::vector<double> Body::temperature_at_nodes(double t) const {
  if (!impl_->temperature) return {};
  const std::span<const Vector3> nodes = std::span(impl_->mesh.nodes).first(impl_->mesh.n_cell_nodes());
  std::vector<double> result(nodes.size());
  TemperatureMemo memo;
  impl_->temperature->on(impl_->mesh).at(nodes)->evaluate(t, result, memo);
  return result;
}

bool Body::stiffness_changes() const {
  return impl_->temperature && impl_->temperature->depends_on_time() && moduli_depend_on_temperature(impl_->material);
}

void Body::update(double t, BodyConditions& at, std::span<const double> temperature) const {
  if (at.updated_to == t && temperature.empty()) return;
  const bool first = !at.updated_to.has_value();
  at.updated_to.reset();  // stays so if something below throws
  at.time = t;
  const material::Material& material = impl_->material;
  const std::size_t n_points = impl_->discretization.n_points();

  const bool new_temperature = impl_->temperature && (first || impl_->temperature->depends_on_time());
  if (new_temperature) {
    at.temperature.resize(n_points);
    if (temperature.empty())
      impl_->temperature_at_points->evaluate(t, at.temperature, at.memo);
    else
      std::ranges::copy(temperature, at.temperature.begin());
    if (!material.thermal_expansion.is_zero()) expand(material, impl_->axes, impl_->initial_strain, at);
  }
  if (first && at.thermal_tensors.empty())
    at.thermal_tensors.assign(impl_->initial_strain.begin(), impl_->initial_strain.end());
  if (first || (new_temperature && moduli_depend_on_temperature(material))) {
    at.moduli.clear();
    if (!impl_->temperature || !moduli_depend_on_temperature(material))
      at.moduli.push_back(moduli_at(material, material.reference_temperature));
    else if (!impl_->temperature->depends_on_position())
      at.moduli.push_back(moduli_at(material, (*impl_->temperature)({.t = t})));
    else
      for (const double T : at.temperature) at.moduli.push_back(moduli_at(material, T));
  }

  if (material.orthotropy && (first || (new_temperature && material.orthotropy->depends_on_temperature())))
    at.matrices = matrices_at(material, impl_->axes, at.temperature, n_points);

  const std::size_t n_full = 3 * impl_->mesh.nodes.size();
  at.external.assign(n_full + 3 * impl_->discretization.n_inner(), 0.0);
  for (const auto& load : impl_->loads) load->add(t, at.external);
  require_finite(impl_->name, at.external, t);
  require_finite(impl_->name, at.thermal_strain, t);
  require_finite(impl_->name, at.thermal_tensors, t);
  const auto end_of_nodes = at.external.begin() + n_full;
  at.has_inner_force = std::any_of(end_of_nodes, at.external.end(), [](double force) { return force != 0; });
  at.known.assign(at.external.begin(), end_of_nodes);
  at.prescribed.resize(n_full);
  if (impl_->constraints.prescribed(t, at.prescribed)) {
    std::vector<double> stress(6 * n_points), forces(n_full);
    impl_->discretization.stress(at.prescribed, at.stiffness(), {}, stress);
    impl_->discretization.add_internal_force(stress, forces);
    for (std::size_t i = 0; i < n_full; ++i) at.known[i] -= forces[i];
  }
  require_finite(impl_->name, at.known, t);
  at.updated_to = t;
}

}  // namespace creepcontact::mechanics
