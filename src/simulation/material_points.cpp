#include "creepcontact/simulation/material_points.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>

namespace creepcontact::simulation {
namespace {

using Index = std::ptrdiff_t;

}  // namespace

MaterialPoints::MaterialPoints(mechanics::Body& body)
    : body_(body),
      n_points_(body.discretization().n_points()),
      stride_(static_cast<std::size_t>(body.material().n_state())) {
  for (const auto& law : body.material().creep) {
    n_parameters_ += static_cast<std::size_t>(law->n_parameters());
    for (const Function& parameter : law->parameters()) uniform_ = uniform_ && !parameter.depends_on_temperature();
  }
  if (empty()) return;
  locals_.resize(n_points_);
  time_ = std::nan("");
  set_time(0);
}

void MaterialPoints::set_time(double t) {
  if (empty() || t == time_) return;
  const bool first = std::isnan(time_);
  time_ = t;
  const std::span<const double> temperature = body_.temperature(t);
  if (!first && (temperature.empty() || std::equal(temperature.begin(), temperature.end(), temperature_.begin())))
    return;
  temperature_.assign(temperature.begin(), temperature.end());
  if (uniform_ && !first) return;
  const std::size_t n_sets = uniform_ || temperature.empty() ? 1 : n_points_;
  uniform_ = n_sets == 1;
  parameters_.clear();
  parameters_.reserve(n_sets * n_parameters_);
  for (std::size_t p = 0; p < n_sets; ++p) {
    const Arguments at{.T = temperature.empty() ? body_.material().reference_temperature : temperature[p]};
    for (const auto& law : body_.material().creep)
      for (const Function& parameter : law->parameters()) parameters_.push_back(parameter(at));
  }
}

material::Point MaterialPoints::point(std::size_t p, std::span<const double> stress, const double* state) const {
  material::Point at;
  at.stress = stress.data() + 6 * p;
  at.state = state + stride_ * p;
  at.internal = at.state + 6;
  at.parameters = parameters_.data() + (uniform_ ? 0 : p * n_parameters_);
  at.time = time_;
  at.temperature = temperature_.empty() ? body_.material().reference_temperature : temperature_[p];
  return at;
}

void MaterialPoints::rate(std::span<const double> stress, const double* state, double* rate) const {
#pragma omp parallel for schedule(static) if (n_points_ > 2000)
  for (Index i = 0; i < static_cast<Index>(n_points_); ++i) {
    const auto p = static_cast<std::size_t>(i);
    material::Point at = point(p, stress, state);
    double* strain_rate = rate + stride_ * p;
    double* internal_rate = strain_rate + 6;
    std::fill(strain_rate, internal_rate, 0.0);
    for (const auto& law : body_.material().creep) {
      law->rate(at, strain_rate, internal_rate);
      at.internal += law->n_internal();
      at.parameters += law->n_parameters();
      internal_rate += law->n_internal();
    }
  }
}

void MaterialPoints::derivative(std::span<const double> stress, const double* state, std::span<const double> d_stress,
                                const double* d_state, double* d_rate) const {
#pragma omp parallel for schedule(static) if (n_points_ > 2000)
  for (Index i = 0; i < static_cast<Index>(n_points_); ++i) {
    const auto p = static_cast<std::size_t>(i);
    derivative_at(p, stress, state, d_stress.data() + 6 * p, d_state + stride_ * p, d_rate + stride_ * p);
  }
}

void MaterialPoints::derivative_at(std::size_t p, std::span<const double> stress, const double* state,
                                   const double* d_stress, const double* d_state, double* d_rate) const {
  material::Point at = point(p, stress, state);
  const double* d_internal = d_state + 6;
  double* d_internal_rate = d_rate + 6;
  std::fill(d_rate, d_internal_rate, 0.0);
  for (const auto& law : body_.material().creep) {
    law->derivative(at, d_stress, d_state, d_internal, d_rate, d_internal_rate);
    at.internal += law->n_internal();
    at.parameters += law->n_parameters();
    d_internal += law->n_internal();
    d_internal_rate += law->n_internal();
  }
}

material::StressTangent MaterialPoints::tangent(material::Point at) const {
  material::StressTangent sum;
  for (const auto& law : body_.material().creep) {
    const material::StressTangent part = law->stress_tangent(at);
    sum.deviatoric += part.deviatoric;
    sum.radial += part.radial;
    sum.volumetric += part.volumetric;
    at.internal += law->n_internal();
    at.parameters += law->n_parameters();
  }
  return sum;
}

void MaterialPoints::linearize(std::span<const double> stress, const double* state) {
#pragma omp parallel for schedule(static) if (n_points_ > 2000)
  for (Index i = 0; i < static_cast<Index>(n_points_); ++i) {
    const auto p = static_cast<std::size_t>(i);
    const material::StressTangent part = tangent(point(p, stress, state));
    Tensor6 direction = tensor::deviator(Eigen::Map<const Tensor6>(stress.data() + 6 * p));
    if (const double length = direction.norm(); length > 0) direction /= length;
    std::copy(direction.begin(), direction.end(), locals_[p].direction);
    locals_[p].deviatoric = part.deviatoric;
    locals_[p].radial = part.radial;
    locals_[p].volumetric = part.volumetric;
  }
}

void MaterialPoints::precondition(double gamma, const double* r, double* z) const {
  const mechanics::ElasticState elastic = body_.elastic();
#pragma omp parallel for schedule(static) if (n_points_ > 2000)
  for (Index i = 0; i < static_cast<Index>(n_points_); ++i) {
    const auto p = static_cast<std::size_t>(i);
    const Local& local = locals_[p];
    const material::Moduli& moduli = elastic.at(p);
    const double shear = 2 * gamma * moduli.mu;
    const double bulk = gamma * (3 * moduli.lambda + 2 * moduli.mu);
    const double a = shear * local.deviatoric;
    const double b = shear * local.radial;
    const Eigen::Map<const Tensor6> right(r + stride_ * p);
    const Eigen::Map<const Tensor6> direction(local.direction);
    Eigen::Map<Tensor6> result(z + stride_ * p);
    const double mean = tensor::trace(right) / 3;
    Tensor6 deviator = right;
    deviator.head<3>().array() -= mean;
    result = (deviator - (b / (1 + a + b)) * direction.dot(deviator) * direction) / (1 + a);
    result.head<3>().array() += mean / (1 + bulk * local.volumetric);
    for (std::size_t k = 6; k < stride_; ++k) z[stride_ * p + k] = r[stride_ * p + k];
  }
}

double MaterialPoints::stiffest_rate(std::span<const double> stress, const double* state) const {
  const mechanics::ElasticState elastic = body_.elastic();
  double stiffest = 0;
#pragma omp parallel for schedule(static) reduction(max : stiffest) if (n_points_ > 2000)
  for (Index i = 0; i < static_cast<Index>(n_points_); ++i) {
    const auto p = static_cast<std::size_t>(i);
    const material::StressTangent part = tangent(point(p, stress, state));
    const material::Moduli& moduli = elastic.at(p);
    stiffest = std::max({stiffest, 2 * moduli.mu * (part.deviatoric + std::max(part.radial, 0.0)),
                         (3 * moduli.lambda + 2 * moduli.mu) * part.volumetric});
  }
  return stiffest;
}

}  // namespace creepcontact::simulation
