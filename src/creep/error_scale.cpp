#include "creepcontact/creep/error_scale.hpp"

#include <algorithm>
#include <cmath>

#include "creepcontact/numerics/point_sums.hpp"
#include "gasket_creep.hpp"

namespace creepcontact::creep {
namespace {

constexpr double min_share_of_largest = 1e-2;  // of the most stressed body: others need no finer resolution
/// Part of the largest stress of the loads without creep: bodies that carry less count as unloaded.
constexpr double min_share_of_elastic = 1e-3;
/// Scale relative to the change of a life per cycle: an error of half a per cent at a tolerance of 1e-4.
constexpr double cycle_resolution = 50;
constexpr double strain_of_unloaded_gaskets = 1e-3;  // where nothing is known of its pressures
constexpr double share_of_range = 0.25;  // of temperatures: with a tolerance of 1e-3 errors of 1e-4 of their range
/// Part of the stress that the whole range of temperatures would make in a body that is held: before it is heated, a
/// body may be without stress.
constexpr double min_share_of_thermal = 1e-3;
constexpr double steady = 0.1;  // relative changes up to here leave the scale as it is

/// Young's modulus at the first point, from the process that has it.
double young_modulus(const Team& team, const mechanics::Body& body, const mechanics::BodyConditions& at) {
  const auto& own = body.own_elements();
  if (at.moduli.empty() || (own && (own->empty() || own->front() > 0))) return team.max(0.0);
  const material::Moduli& h = at.moduli.front();
  return team.max(h.mu * (3 * h.lambda + 2 * h.mu) / (h.lambda + h.mu));
}

/// Thermal strain per degree, about.
double expansion(const mechanics::Body& body) {
  const material::Material& material = body.material();
  const double T = material.reference_temperature;
  return material.thermal_expansion.strains(T + 1, T).cwiseAbs().maxCoeff();
}

}  // namespace

ErrorScale::ErrorScale(const Assembly& assembly, const std::vector<double>& elastic_stress,
                       const std::vector<double>& gasket_strain)
    : assembly_(assembly),
      layout_(assembly),
      strain_(assembly.bodies().size(), 0.0),
      thermal_stress_(assembly.bodies().size(), 0.0),
      gasket_strain_(assembly.pairs().size(), 0.0),
      least_gasket_strain_(gasket_strain_),
      values_(layout_.size(), 1.0) {
  for (std::size_t b = 0; b < strain_.size(); ++b) {
    std::size_t column = 6;
    for (const auto& law : assembly.bodies()[b].material().creep)
      for (int k = 0; k < law->n_internal(); ++k, ++column)
        if (law->internal_kind(k) == material::InternalKind::life) lives_.push_back({b, column});
  }
  if (const HeatModel* heat = assembly.heat(); heat != nullptr)
    for (std::size_t b = 0; b < strain_.size(); ++b) {
      const mechanics::Body& body = assembly.bodies()[b];
      thermal_stress_[b] =
          min_share_of_thermal * heat->range * expansion(body) * young_modulus(assembly.team(), body, body.at(0));
    }
  set_temperatures();
  if (elastic_stress.empty()) return;
  const double largest = *std::ranges::max_element(elastic_stress);
  least_ = min_share_of_elastic * largest;
  for (std::size_t b = 0; b < strain_.size(); ++b)
    set(b, std::max({elastic_stress[b], min_share_of_largest * largest, thermal_stress_[b]}) /
               young_modulus(assembly.team(), assembly.bodies()[b], assembly.bodies()[b].at(0)));
  for (std::size_t p = 0; p < gasket_strain.size(); ++p) {
    least_gasket_strain_[p] = min_share_of_largest * gasket_strain[p];
    if (gasket_stride(assembly.pairs()[p]) > 0)
      set_gasket(p, gasket_strain[p] > 0 ? gasket_strain[p] : strain_of_unloaded_gaskets);
  }
}

std::vector<double> ErrorScale::typical(const Assembly& assembly, const Equilibrium& at) {
  const std::size_t n_bodies = at.bodies.size();
  std::vector<double> sums;  // of the squares, then of the points
  for (const BodyState& state : at.bodies)
    sums.push_back(numerics::sum_over_points(state.stress.size() / 6, [&](std::size_t p) {
      return tensor::squared_von_mises(tensor::view(state.stress, p));
    }));
  for (const BodyState& state : at.bodies) {
    const std::size_t n_points = state.stress.size() / 6;
    sums.push_back(static_cast<double>(n_points));
  }
  assembly.team().sum(sums);
  std::vector<double> result(n_bodies);
  for (std::size_t b = 0; b < n_bodies; ++b) result[b] = std::sqrt(sums[b] / sums[n_bodies + b]);
  return result;
}

void ErrorScale::follow(const Equilibrium& at) {
  const std::vector<double> stress = typical(assembly_, at);
  const double largest = *std::ranges::max_element(stress);
  for (std::size_t b = 0; b < strain_.size(); ++b) {
    const double now = std::max({stress[b], min_share_of_largest * largest, least_, thermal_stress_[b]}) /
                       young_modulus(assembly_.team(), assembly_.bodies()[b], at.conditions[b]);
    if (std::abs(now - strain_[b]) > steady * strain_[b]) set(b, now);
  }
  const std::vector<double> of_gaskets = typical_gasket_strains(assembly_, at);
  for (std::size_t p = 0; p < of_gaskets.size(); ++p) {
    const double now = std::max(of_gaskets[p], least_gasket_strain_[p]);
    if (now > 0 && std::abs(now - gasket_strain_[p]) > steady * gasket_strain_[p]) set_gasket(p, now);
  }
}

void ErrorScale::resolve_cycle(std::span<const double> change, double least) {
  if (lives_.empty()) return;
  std::vector<double> largest(lives_.size(), least);
  for (std::size_t i = 0; i < lives_.size(); ++i) {
    const std::span<const double> own = layout_.part(lives_[i].body, change);
    for (std::size_t at = lives_[i].column; at < own.size(); at += layout_.stride(lives_[i].body))
      largest[i] = std::max(largest[i], std::abs(own[at]));
  }
  assembly_.team().max(largest);
  for (std::size_t i = 0; i < lives_.size(); ++i) lives_[i].scale = std::min(1.0, cycle_resolution * largest[i]);
  for (std::size_t b = 0; b < strain_.size(); ++b) set(b, strain_[b]);
}

void ErrorScale::save(Memory& memory) const {
  memory.save("scale.strain", strain_);
  memory.save("scale.gaskets", gasket_strain_);
  memory.save("scale.lives", lives_);
}

void ErrorScale::restore(const Memory& memory) {
  memory.restore("scale.strain", strain_);
  memory.restore("scale.gaskets", gasket_strain_);
  memory.restore("scale.lives", lives_);
  for (std::size_t b = 0; b < strain_.size(); ++b) set(b, strain_[b]);
  for (std::size_t p = 0; p < gasket_strain_.size(); ++p) set_gasket(p, gasket_strain_[p]);
}

std::vector<double> ErrorScale::of_point(std::size_t body) const {
  std::vector<double> result(std::min<std::size_t>(6, layout_.stride(body)), strain_[body]);
  for (const auto& law : assembly_.bodies()[body].material().creep)
    for (int k = 0; k < law->n_internal(); ++k)
      result.push_back(law->internal_kind(k) == material::InternalKind::strain ? strain_[body] : 1.0);
  return result;
}

void ErrorScale::fill(std::size_t body, std::span<const double> of_point, std::vector<double>& values) const {
  auto at = values.begin() + static_cast<std::ptrdiff_t>(layout_.offset(body));
  for (std::size_t p = 0; p < assembly_.bodies()[body].discretization().n_points(); ++p)
    at = std::ranges::copy(of_point, at).out;
}

std::vector<double> ErrorScale::of_whole_run() const {
  std::vector<double> result = values_;
  for (std::size_t b = 0; b < strain_.size(); ++b) fill(b, of_point(b), result);
  return result;
}

void ErrorScale::set_gasket(std::size_t pair, double strain) {
  gasket_strain_[pair] = strain;
  if (layout_.n_gaskets() == 0) return;  // none creeps, or another process has them
  auto at = layout_.gaskets(std::span(values_)).begin();
  for (std::size_t p = 0; p < assembly_.pairs().size(); ++p) {
    const contact::Pair& other = assembly_.pairs()[p];
    if (gasket_stride(other) == 0) continue;
    std::vector<double> of_node{strain};
    for (const auto& law : other.gasket->kind().creep->creep)
      for (int k = 0; k < law->n_internal(); ++k)
        of_node.push_back(law->internal_kind(k) == material::InternalKind::strain ? strain : 1.0);
    for (std::size_t i = 0; i < other.coupling.nodes.size(); ++i)
      at = p == pair ? std::ranges::copy(of_node, at).out : at + std::ssize(of_node);
  }
}

void ErrorScale::set_temperatures() {
  const HeatModel* heat = assembly_.heat();
  if (heat == nullptr) return;
  double scale = share_of_range * heat->range;
  for (std::size_t b = 0; b < strain_.size(); ++b) {
    const double per_degree = expansion(assembly_.bodies()[b]);
    if (strain_[b] > 0 && per_degree > 0) scale = std::min(scale, strain_[b] / per_degree);
  }
  std::ranges::fill(layout_.temperatures(std::span(values_)), scale);
}

void ErrorScale::set(std::size_t body, double strain) {
  strain_[body] = strain;
  set_temperatures();
  std::vector<double> scales = of_point(body);
  for (const Life& life : lives_)
    if (life.body == body) scales[life.column] = life.scale;
  fill(body, scales, values_);
}

}  // namespace creepcontact::creep
