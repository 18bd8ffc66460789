#include "creepcontact/creep/material_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/numerics/parallel.hpp"

namespace creepcontact::creep {
namespace {

using Index = std::ptrdiff_t;

}  // namespace

template <typename Call>
void MaterialPoints::for_each_law(std::size_t p, const PointsState& at_points, Call call) const {
  material::Point at = point(p, at_points);
  std::size_t offset = 6;
  for (const auto& law : body_.material().creep) {
    call(*law, std::as_const(at), offset);
    at.internal += law->n_internal();
    at.parameters += law->n_parameters();
    offset += static_cast<std::size_t>(law->n_internal());
  }
}

MaterialPoints::MaterialPoints(const mechanics::Body& body, double least_strain)
    : body_(body),
      n_points_(body.discretization().n_points()),
      stride_(static_cast<std::size_t>(body.material().n_state())),
      least_strain_(least_strain) {
  for (const auto& law : body.material().creep) {
    fits_mean_stress_ = fits_mean_stress_ || law->uses_mean_stress();
    n_parameters_ += static_cast<std::size_t>(law->n_parameters());
    for (const Function& parameter : law->parameters())
      depends_on_temperature_ = depends_on_temperature_ || parameter.depends_on_temperature();
  }
  fits_mean_stress_ = fits_mean_stress_ && body.discretization().fits_mean_stress();
  if (empty()) return;
  const std::vector<double> nothing(std::max<std::size_t>(6, stride_), 0.0);
  LawParameters laws;
  update(body.at(0), laws);
  for_each_law(0, {laws, {}, nothing, nothing.data()},
               [&](const material::CreepLaw& law, const material::Point& at, std::size_t) {
                 for (const material::Measure one : {material::Measure::damage, material::Measure::life_fraction})
                   if (law.measure(one, at)) known_[static_cast<std::size_t>(one)] = true;
               });
}

void MaterialPoints::update(const mechanics::BodyConditions& at, LawParameters& into) const {
  into.time = at.time;
  if (empty() || (into.evaluated && into.temperature == at.temperature)) return;
  const bool first = !std::exchange(into.evaluated, false);
  into.temperature = at.temperature;
  into.uniform = !depends_on_temperature_ || at.temperature.empty();
  if (first || !into.uniform) {
    into.values.clear();
    const std::size_t n_sets = into.uniform ? 1 : n_points_;
    into.values.reserve(n_sets * n_parameters_);
    try {
      for (std::size_t p = 0; p < n_sets; ++p) {
        const Arguments here{.T = at.temperature.empty() ? body_.material().reference_temperature : at.temperature[p]};
        for (const auto& law : body_.material().creep)
          for (const Function& parameter : law->parameters()) into.values.push_back(parameter(here));
      }
    } catch (const ModelError& error) {
      throw ModelError(fmt::format("material '{}': {}", body_.material().name, error.what()));
    }
  }
  into.evaluated = true;
}

material::Point MaterialPoints::point(std::size_t p, const PointsState& at_points) const {
  const LawParameters& laws = at_points.laws;
  material::Point at;
  at.stress = at_points.stress.data() + 6 * p;
  at.state = at_points.state + stride_ * p;
  at.internal = at.state + 6;
  at.parameters = laws.values.data() + (laws.uniform ? 0 : p * n_parameters_);
  at.time = laws.time;
  at.least_strain = least_strain_;
  at.temperature = laws.temperature.empty() ? body_.material().reference_temperature : laws.temperature[p];
  return at;
}

MaterialPoints::LawStress::LawStress(const MaterialPoints& points, std::span<const double> stress) : given_(stress) {
  if (!points.fits_mean_stress_) return;
  fitted_.assign(stress.begin(), stress.end());
  points.body_.discretization().fit_mean_stress(fitted_);
}

void MaterialPoints::rate(const PointsState& given, double* rate) const {
  const LawStress stress(*this, given.stress);
  const PointsState at_points{given.laws, given.elastic, stress, given.state};
  numerics::for_each_index(n_points_, numerics::parallel_points, [&](std::size_t p) {
    double* own = rate + stride_ * p;
    std::fill(own, own + 6, 0.0);
    for_each_law(p, at_points, [&](const material::CreepLaw& law, const material::Point& at, std::size_t internal) {
      law.rate(at, own, own + internal);
    });
  });
}

void MaterialPoints::derivative(const PointsState& given, std::span<const double> given_change, const double* d_state,
                                double* d_rate) const {
  const LawStress stress(*this, given.stress), change(*this, given_change);
  const PointsState at{given.laws, given.elastic, stress, given.state};
  const std::span<const double> d_stress = change;
  numerics::for_each_index(n_points_, numerics::parallel_points, [&](std::size_t p) {
    derivative_at(p, at, d_stress.data() + 6 * p, d_state + stride_ * p, d_rate + stride_ * p);
  });
}

void MaterialPoints::derivative_at(std::size_t p, const PointsState& at_points, const double* d_stress,
                                   const double* d_state, double* d_rate) const {
  std::fill(d_rate, d_rate + 6, 0.0);
  for_each_law(p, at_points, [&](const material::CreepLaw& law, const material::Point& at, std::size_t internal) {
    law.derivative(at, d_stress, d_state, d_state + internal, d_rate, d_rate + internal);
  });
}

double MaterialPoints::start_exponent(double t, const PointsState& at_points) const {
  double smallest = 1;
#pragma omp parallel for schedule(static) reduction(min : smallest) if (n_points_ >= numerics::parallel_points)
  for (Index i = 0; i < static_cast<Index>(n_points_); ++i)
    for_each_law(static_cast<std::size_t>(i), at_points,
                 [&](const material::CreepLaw& law, material::Point at, std::size_t) {
                   at.time = t;
                   smallest = std::min(smallest, law.start_exponent(at));
                 });
  return smallest;
}

void MaterialPoints::add_increment(double t, double duration, const PointsState& given, double* change) const {
  const LawStress stress(*this, given.stress);
  const PointsState at_points{given.laws, given.elastic, stress, given.state};
  numerics::for_each_index(n_points_, numerics::parallel_points, [&](std::size_t p) {
    double* own = change + stride_ * p;
    for_each_law(p, at_points, [&](const material::CreepLaw& law, material::Point at, std::size_t internal) {
      at.time = t;
      law.increment(at, duration, own, own + internal);
    });
  });
}

std::vector<double> MaterialPoints::measure(material::Measure of, const PointsState& at_points) const {
  std::vector<double> values(n_points_, 0.0);
  numerics::for_each_index(n_points_, numerics::parallel_points, [&](std::size_t p) {
    for_each_law(p, at_points, [&](const material::CreepLaw& law, const material::Point& at, std::size_t) {
      if (const std::optional<double> value = law.measure(of, at)) values[p] = std::max(values[p], *value);
    });
  });
  return values;
}

material::StressTangent MaterialPoints::tangent(std::size_t p, const PointsState& at_points) const {
  material::StressTangent sum;
  for_each_law(p, at_points, [&](const material::CreepLaw& law, const material::Point& at, std::size_t) {
    const material::StressTangent part = law.stress_tangent(at);
    sum.deviatoric += part.deviatoric;
    sum.radial += part.radial;
    sum.volumetric += part.volumetric;
  });
  return sum;
}

double MaterialPoints::stiffest_with_internal(std::size_t p, const PointsState& at, Eigen::VectorXd& v,
                                              Eigen::VectorXd& product) const {
  constexpr int iterations = 12;
  v.setOnes();
  double size = 0;
  for (int i = 0; i < iterations; ++i) {
    v.normalize();
    const Tensor6 change = -material::stress(at.elastic.at(p), v.head<6>());
    derivative_at(p, at, change.data(), v.data(), product.data());
    size = product.norm();
    if (!(size > 0)) return 0;
    v.swap(product);
  }
  return size;
}

double MaterialPoints::stiffest_rate(const PointsState& at) const {
  double stiffest = 0;
#pragma omp parallel reduction(max : stiffest) if (n_points_ >= numerics::parallel_points)
  {
    Eigen::VectorXd v(stride_), product(stride_);
#pragma omp for schedule(static)
    for (Index i = 0; i < static_cast<Index>(n_points_); ++i) {
      const auto p = static_cast<std::size_t>(i);
      const material::StressTangent part = tangent(p, at);
      const material::Moduli& moduli = at.elastic.at(p);
      stiffest = std::max({stiffest, 2 * moduli.mu * (part.deviatoric + std::max(part.radial, 0.0)),
                           (3 * moduli.lambda + 2 * moduli.mu) * part.volumetric});
      if (has_internal_variables()) stiffest = std::max(stiffest, stiffest_with_internal(p, at, v, product));
    }
  }
  return stiffest;
}

}  // namespace creepcontact::creep
