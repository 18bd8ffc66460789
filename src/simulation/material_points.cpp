#include "creepcontact/simulation/material_points.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "creepcontact/base/error.hpp"

namespace creepcontact::simulation {
namespace {

using Index = std::ptrdiff_t;

}  // namespace

template <typename Call>
void MaterialPoints::for_each_law(std::size_t p, std::span<const double> stress, const double* state, Call call) const {
  material::Point at = point(p, stress, state);
  std::size_t offset = 6;
  for (const auto& law : body_.material().creep) {
    call(*law, std::as_const(at), offset);
    at.internal += law->n_internal();
    at.parameters += law->n_parameters();
    offset += static_cast<std::size_t>(law->n_internal());
  }
}

MaterialPoints::MaterialPoints(mechanics::Body& body)
    : body_(body),
      n_points_(body.discretization().n_points()),
      stride_(static_cast<std::size_t>(body.material().n_state())) {
  for (const auto& law : body.material().creep) {
    fits_mean_stress_ = fits_mean_stress_ || law->uses_mean_stress();
    n_parameters_ += static_cast<std::size_t>(law->n_parameters());
    for (const Function& parameter : law->parameters()) uniform_ = uniform_ && !parameter.depends_on_temperature();
  }
  fits_mean_stress_ = fits_mean_stress_ && body.discretization().fits_mean_stress();
  if (empty()) return;
  locals_.resize(n_points_);
  time_ = std::nan("");
  set_time(0);
  const std::vector<double> nothing(std::max<std::size_t>(6, stride_), 0.0);
  for_each_law(0, nothing, nothing.data(), [&](const material::CreepLaw& law, const material::Point& at, std::size_t) {
    for (const material::Measure one : {material::Measure::damage, material::Measure::life_fraction})
      if (law.measure(one, at)) known_[static_cast<std::size_t>(one)] = true;
  });
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
  try {
    for (std::size_t p = 0; p < n_sets; ++p) {
      const Arguments at{.T = temperature.empty() ? body_.material().reference_temperature : temperature[p]};
      for (const auto& law : body_.material().creep)
        for (const Function& parameter : law->parameters()) parameters_.push_back(parameter(at));
    }
  } catch (const ModelError& error) {
    throw ModelError(fmt::format("material '{}': {}", body_.material().name, error.what()));
  }
}

material::Point MaterialPoints::point(std::size_t p, std::span<const double> stress, const double* state) const {
  material::Point at;
  at.stress = stress.data() + 6 * p;
  at.state = state + stride_ * p;
  at.internal = at.state + 6;
  at.parameters = parameters_.data() + (uniform_ ? 0 : p * n_parameters_);
  at.time = time_;
  at.least_strain = least_strain_;
  at.temperature = temperature_.empty() ? body_.material().reference_temperature : temperature_[p];
  return at;
}

MaterialPoints::LawStress::LawStress(const MaterialPoints& points, std::span<const double> stress) : given_(stress) {
  if (!points.fits_mean_stress_) return;
  fitted_.assign(stress.begin(), stress.end());
  points.body_.discretization().fit_mean_stress(fitted_);
}

void MaterialPoints::rate(std::span<const double> given_stress, const double* state, double* rate) const {
  const LawStress stress(*this, given_stress);
#pragma omp parallel for schedule(static) if (n_points_ > 2000)
  for (Index i = 0; i < static_cast<Index>(n_points_); ++i) {
    const auto p = static_cast<std::size_t>(i);
    double* own = rate + stride_ * p;
    std::fill(own, own + 6, 0.0);
    for_each_law(p, stress, state, [&](const material::CreepLaw& law, const material::Point& at, std::size_t internal) {
      law.rate(at, own, own + internal);
    });
  }
}

void MaterialPoints::derivative(std::span<const double> given_stress, const double* state,
                                std::span<const double> given_change, const double* d_state, double* d_rate) const {
  const LawStress stress(*this, given_stress), change(*this, given_change);
  const std::span<const double> d_stress = change;
#pragma omp parallel for schedule(static) if (n_points_ > 2000)
  for (Index i = 0; i < static_cast<Index>(n_points_); ++i) {
    const auto p = static_cast<std::size_t>(i);
    derivative_at(p, stress, state, d_stress.data() + 6 * p, d_state + stride_ * p, d_rate + stride_ * p);
  }
}

void MaterialPoints::derivative_at(std::size_t p, std::span<const double> stress, const double* state,
                                   const double* d_stress, const double* d_state, double* d_rate) const {
  std::fill(d_rate, d_rate + 6, 0.0);
  for_each_law(p, stress, state, [&](const material::CreepLaw& law, const material::Point& at, std::size_t internal) {
    law.derivative(at, d_stress, d_state, d_state + internal, d_rate, d_rate + internal);
  });
}

double MaterialPoints::start_exponent(double t, std::span<const double> stress, const double* state) const {
  double smallest = 1;
#pragma omp parallel for schedule(static) reduction(min : smallest) if (n_points_ > 2000)
  for (Index i = 0; i < static_cast<Index>(n_points_); ++i)
    for_each_law(static_cast<std::size_t>(i), stress, state,
                 [&](const material::CreepLaw& law, material::Point at, std::size_t) {
                   at.time = t;
                   smallest = std::min(smallest, law.start_exponent(at));
                 });
  return smallest;
}

void MaterialPoints::add_increment(double t, double duration, std::span<const double> given_stress, const double* state,
                                   double* change) const {
  const LawStress stress(*this, given_stress);
#pragma omp parallel for schedule(static) if (n_points_ > 2000)
  for (Index i = 0; i < static_cast<Index>(n_points_); ++i) {
    const auto p = static_cast<std::size_t>(i);
    double* own = change + stride_ * p;
    for_each_law(p, stress, state, [&](const material::CreepLaw& law, material::Point at, std::size_t internal) {
      at.time = t;
      law.increment(at, duration, own, own + internal);
    });
  }
}

std::vector<double> MaterialPoints::measure(material::Measure of, std::span<const double> stress,
                                            const double* state) const {
  std::vector<double> values(n_points_, 0.0);
#pragma omp parallel for schedule(static) if (n_points_ > 2000)
  for (Index i = 0; i < static_cast<Index>(n_points_); ++i) {
    const auto p = static_cast<std::size_t>(i);
    for_each_law(p, stress, state, [&](const material::CreepLaw& law, const material::Point& at, std::size_t) {
      if (const std::optional<double> value = law.measure(of, at)) values[p] = std::max(values[p], *value);
    });
  }
  return values;
}

material::StressTangent MaterialPoints::tangent(std::size_t p, std::span<const double> stress,
                                                const double* state) const {
  material::StressTangent sum;
  for_each_law(p, stress, state, [&](const material::CreepLaw& law, const material::Point& at, std::size_t) {
    const material::StressTangent part = law.stress_tangent(at);
    sum.deviatoric += part.deviatoric;
    sum.radial += part.radial;
    sum.volumetric += part.volumetric;
  });
  return sum;
}

void MaterialPoints::linearize(std::span<const double> stress, const double* state) {
  const mechanics::ElasticState elastic = body_.elastic();
#pragma omp parallel for schedule(static) if (n_points_ > 2000)
  for (Index i = 0; i < static_cast<Index>(n_points_); ++i) {
    const auto p = static_cast<std::size_t>(i);
    const material::StressTangent part = tangent(p, stress, state);
    Tensor6 direction = tensor::deviator(Eigen::Map<const Tensor6>(stress.data() + 6 * p));
    if (const double length = direction.norm(); length > 0) direction /= length;
    std::copy(direction.begin(), direction.end(), locals_[p].direction);
    const material::Moduli& moduli = elastic.at(p);
    locals_[p].deviatoric = 2 * moduli.mu * part.deviatoric;
    locals_[p].radial = 2 * moduli.mu * part.radial;
    locals_[p].volumetric = (3 * moduli.lambda + 2 * moduli.mu) * part.volumetric;
  }
}

void MaterialPoints::precondition(double gamma, const double* r, double* z) const {
#pragma omp parallel for schedule(static) if (n_points_ > 2000)
  for (Index i = 0; i < static_cast<Index>(n_points_); ++i) {
    const auto p = static_cast<std::size_t>(i);
    const Local& local = locals_[p];
    const double a = gamma * local.deviatoric;
    const double b = gamma * local.radial;
    const Eigen::Map<const Tensor6> right(r + stride_ * p);
    const Eigen::Map<const Tensor6> direction(local.direction);
    Eigen::Map<Tensor6> result(z + stride_ * p);
    const double mean = tensor::trace(right) / 3;
    Tensor6 deviator = right;
    deviator.head<3>().array() -= mean;
    result = (deviator - (b / (1 + a + b)) * direction.dot(deviator) * direction) / (1 + a);
    result.head<3>().array() += mean / (1 + gamma * local.volumetric);
    for (std::size_t k = 6; k < stride_; ++k) z[stride_ * p + k] = r[stride_ * p + k];
  }
}

double MaterialPoints::stiffest_with_internal(std::size_t p, std::span<const double> stress, const double* state,
                                              Eigen::VectorXd& v, Eigen::VectorXd& product) const {
  constexpr int iterations = 12;
  v.setOnes();
  double size = 0;
  for (int i = 0; i < iterations; ++i) {
    v.normalize();
    const Tensor6 change = -material::stress(body_.elastic().at(p), v.head<6>());
    derivative_at(p, stress, state, change.data(), v.data(), product.data());
    size = product.norm();
    if (!(size > 0)) return 0;
    v.swap(product);
  }
  return size;
}

double MaterialPoints::stiffest_rate(std::span<const double> stress, const double* state) const {
  const mechanics::ElasticState elastic = body_.elastic();
  double stiffest = 0;
#pragma omp parallel reduction(max : stiffest) if (n_points_ > 2000)
  {
    Eigen::VectorXd v(stride_), product(stride_);
#pragma omp for schedule(static)
    for (Index i = 0; i < static_cast<Index>(n_points_); ++i) {
      const auto p = static_cast<std::size_t>(i);
      const material::StressTangent part = tangent(p, stress, state);
      const material::Moduli& moduli = elastic.at(p);
      stiffest = std::max({stiffest, 2 * moduli.mu * (part.deviatoric + std::max(part.radial, 0.0)),
                           (3 * moduli.lambda + 2 * moduli.mu) * part.volumetric});
      if (has_internal_variables()) stiffest = std::max(stiffest, stiffest_with_internal(p, stress, state, v, product));
    }
  }
  return stiffest;
}

}  // namespace creepcontact::simulation
