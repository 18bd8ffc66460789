#include "creepcontact/creep/material_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/numerics/parallel.hpp"

namespace creepcontact::creep {

MaterialPoints::MaterialPoints(const mechanics::Body& body, double min_strain)
    : body_(body),
      n_points_(body.discretization().n_points()),
      stride_(body.material().n_state()),
      min_strain_(min_strain) {
  std::size_t n_state = 6;
  for (const auto& law : body.material().creep) {
    prepares_ = prepares_ || law->n_prepared() > 0;
    mechanisms_.push_back({.law = law.get(),
                           .number = mechanisms_.size(),
                           .internal = {n_state, static_cast<std::size_t>(law->n_internal())},
                           .parameters = {n_parameters_, static_cast<std::size_t>(law->n_parameters())}});
    n_state += mechanisms_.back().internal.size;
    n_parameters_ += mechanisms_.back().parameters.size;
    fits_mean_stress_ = fits_mean_stress_ || law->uses_mean_stress();
    is_coaxial_ = is_coaxial_ && law->is_coaxial();
    is_linear_ = is_linear_ && law->is_linear();
    for (const Function& parameter : law->parameters())
      depends_on_temperature_ = depends_on_temperature_ || parameter.depends_on_temperature();
  }
  fits_mean_stress_ = fits_mean_stress_ && body.discretization().fits_mean_stress();
  if (empty()) return;
  if (const auto& ratios = body.material().hill) {
    const Matrix6 of_axes = material::hill_transformation(*ratios);
    for (const Matrix3& axes : body.material_axes()) hill_.push_back(material::turned(of_axes, axes));
  }
  const std::vector<double> nothing(std::max<std::size_t>(6, stride_), 0.0);
  LawParameters laws;
  update(body.at(0), laws);
  const PointsState at{laws, {}, {}, nothing};
  std::array<double, 6> values;
  for (const material::StateVariable* variable : material::state_variables())
    if (std::ranges::any_of(mechanisms_, [&](const Mechanism& mechanism) {
          return mechanism.law->evaluate(*variable, state_for(mechanism, 0, at, {*this, 0, tensor::zero()}), values);
        }))
      known_.push_back(variable);
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

std::span<const double> MaterialPoints::prepared_for(const Mechanism& mechanism, std::size_t p, const PointsState& at) {
  if (at.prepared == nullptr || at.prepared->empty()) return {};
  const std::vector<double>& values = (*at.prepared)[mechanism.number];
  const std::size_t n = mechanism.law->n_prepared();
  return values.empty() ? std::span<const double>() : std::span(values).subspan(n * p, n);
}

material::PointState MaterialPoints::state_for(const Mechanism& mechanism, std::size_t p, const PointsState& at,
                                               const SeenStress& stress) const {
  const LawParameters& laws = at.laws;
  const std::span<const double> state = of_point(p, at.state);
  const Part parameters{mechanism.parameters.first + (laws.uniform ? 0 : n_parameters_ * p), mechanism.parameters.size};
  return {.stress = stress.of(*mechanism.law),
          .creep_strain = tensor::view(state, 0),
          .internal = mechanism.internal.of(state),
          .parameters = parameters.of(std::span(laws.values)),
          .time = laws.time,
          .temperature = laws.temperature.empty() ? body_.material().reference_temperature : laws.temperature[p],
          .min_strain = min_strain_,
          .prepared = prepared_for(mechanism, p, at)};
}

std::vector<std::vector<double>> MaterialPoints::prepare(const PointsState& at, bool with_derivatives) const {
  if (!prepares_) return {};
  std::vector<std::vector<double>> prepared;
  std::vector<Tensor6> stresses(n_points_);
  for (const Mechanism& mechanism : mechanisms_) {
    prepared.emplace_back();
    if (mechanism.law->n_prepared() == 0) continue;
    std::vector<material::PointState> points;
    points.reserve(n_points_);
    for (std::size_t p = 0; p < n_points_; ++p) {
      const SeenStress seen(*this, p, tensor::view(at.stress, p));
      stresses[p] = seen.of(*mechanism.law);
      material::PointState point = state_for(mechanism, p, at, seen);
      points.push_back({.stress = tensor::view(stresses[p]),
                        .creep_strain = point.creep_strain,
                        .internal = point.internal,
                        .parameters = point.parameters,
                        .time = point.time,
                        .temperature = point.temperature,
                        .min_strain = point.min_strain});
    }
    prepared.back() = mechanism.law->prepare(points, with_derivatives);
  }
  return prepared;
}

MaterialPoints::LawStress::LawStress(const MaterialPoints& points, std::span<const double> stress) : given_(stress) {
  if (!points.fits_mean_stress_) return;
  fitted_.assign(stress.begin(), stress.end());
  points.body_.discretization().fit_mean_stress(fitted_);
}

namespace {
void add(const material::StressTangent& part, material::StressTangent& sum) {
  sum.deviatoric += part.deviatoric;
  sum.radial += part.radial;
  sum.volumetric += part.volumetric;
}
}  // namespace

void MaterialPoints::rate(const PointsState& given, std::span<double> rate,
                          std::span<material::StressTangent> tangents) const {
  const LawStress stress(*this, given.stress);
  PointsState at{given.laws, given.elastic, stress, given.state};
  const auto prepared = prepare(at, !tangents.empty());
  at.prepared = &prepared;
  const auto for_each_law = [&](std::size_t p, const auto& evaluate) {
    const std::span<double> own = of_point(p, rate);
    const SeenStress seen(*this, p, tensor::view(at.stress, p));
    std::fill_n(own.begin(), 6, 0.0);
    for (const Mechanism& mechanism : mechanisms_)
      evaluate(*mechanism.law, state_for(mechanism, p, at, seen),
               material::PointRate{tensor::writable(own, 0), mechanism.internal.of(own)});
    turn_back(p, own);
  };
  numerics::for_each_index(n_points_, numerics::parallel_points, [&](std::size_t p) {
    if (tangents.empty()) {
      for_each_law(p, [](const auto& law, const auto& point, const auto& into) { law.rate(point, into); });
      return;
    }
    material::StressTangent sum;
    for_each_law(
        p, [&](const auto& law, const auto& point, const auto& into) { add(law.rate_and_tangent(point, into), sum); });
    tangents[p] = sum;
  });
}

void MaterialPoints::tangents(const PointsState& given, std::span<material::StressTangent> into) const {
  const LawStress stress(*this, given.stress);
  PointsState at{given.laws, given.elastic, stress, given.state};
  const auto prepared = prepare(at, true);
  at.prepared = &prepared;
  numerics::for_each_index(n_points_, numerics::parallel_points, [&](std::size_t p) {
    const SeenStress seen(*this, p, tensor::view(at.stress, p));
    material::StressTangent sum;
    for (const Mechanism& mechanism : mechanisms_)
      add(mechanism.law->stress_tangent(state_for(mechanism, p, at, seen)), sum);
    into[p] = sum;
  });
}

void MaterialPoints::derivative(const PointsState& given, const PointsChange& given_change,
                                std::span<double> rate_change) const {
  const LawStress stress(*this, given.stress), stress_change(*this, given_change.stress);
  PointsState at{given.laws, given.elastic, stress, given.state};
  const auto prepared = prepare(at, true);
  at.prepared = &prepared;
  const PointsChange change{stress_change, given_change.state};
  numerics::for_each_index(n_points_, numerics::parallel_points, [&](std::size_t p) {
    derivative_at(p, at, {.stress = {change.stress.data() + 6 * p, 6}, .state = of_point(p, change.state)},
                  of_point(p, rate_change));
  });
}

void MaterialPoints::derivative_by_tangents(const PointsState& at, std::span<const material::StressTangent> tangents,
                                            std::span<const double> stress_change,
                                            std::span<double> rate_change) const {
  const LawStress stress(*this, at.stress), change(*this, stress_change);
  const std::span<const double> stresses = stress, changes = change;
  numerics::for_each_index(n_points_, numerics::parallel_points, [&](std::size_t p) {
    const material::StressTangent& tangent = tangents[p];
    const Tensor6 own = tensor::deviator(tensor::view(stresses, p));
    const tensor::ConstMap of = tensor::view(changes, p);
    const double square = own.squaredNorm(), mean = tensor::trace(of) / 3;
    tensor::Map result = tensor::writable(rate_change, p);
    result = tangent.deviatoric * of;
    if (square > std::numeric_limits<double>::min()) result += tangent.radial * own.dot(of) / square * own;
    result.head<3>().array() += (tangent.volumetric - tangent.deviatoric) * mean;
  });
}

void MaterialPoints::derivative_at(std::size_t p, const PointsState& at, const PointsChange& change,
                                   std::span<double> rate_change) const {
  const SeenStress seen(*this, p, tensor::view(at.stress, p)), seen_change(*this, p, tensor::view(change.stress, 0));
  std::fill_n(rate_change.begin(), 6, 0.0);
  for (const Mechanism& mechanism : mechanisms_)
    mechanism.law->derivative(
        state_for(mechanism, p, at, seen),
        {seen_change.of(*mechanism.law), tensor::view(change.state, 0), mechanism.internal.of(change.state)},
        {tensor::writable(rate_change, 0), mechanism.internal.of(rate_change)});
  turn_back(p, rate_change);
}

double MaterialPoints::start_exponent(double t, const PointsState& at_points) const {
  double smallest = 1;
#pragma omp parallel for schedule(static) reduction(min : smallest) if (n_points_ >= numerics::parallel_points)
  for (std::size_t p = 0; p < n_points_; ++p)
    for (const Mechanism& mechanism : mechanisms_) {
      const SeenStress seen(*this, p, tensor::view(at_points.stress, p));
      material::PointState at = state_for(mechanism, p, at_points, seen);
      at.time = t;
      smallest = std::min(smallest, mechanism.law->start_exponent(at));
    }
  return smallest;
}

void MaterialPoints::add_increment(double t, double duration, const PointsState& given,
                                   std::span<double> change) const {
  const LawStress stress(*this, given.stress);
  const PointsState at_points{given.laws, given.elastic, stress, given.state};
  numerics::for_each_index(n_points_, numerics::parallel_points, [&](std::size_t p) {
    const std::span<double> own = of_point(p, change);
    const SeenStress seen(*this, p, tensor::view(at_points.stress, p));
    Tensor6 strain = Tensor6::Zero();
    for (const Mechanism& mechanism : mechanisms_) {
      material::PointState at = state_for(mechanism, p, at_points, seen);
      at.time = t;
      mechanism.law->increment(at, duration, {tensor::writable(strain), mechanism.internal.of(own)});
    }
    turn_back(p, {strain.data(), 6});
    tensor::writable(own, 0) += strain;
  });
}

bool MaterialPoints::counts_cycles() const {
  return std::ranges::any_of(mechanisms_, [](const Mechanism& mechanism) { return mechanism.law->counts_cycles(); });
}

void MaterialPoints::add_cycle(std::span<const material::CycleRange> cycles, std::span<double> state) const {
  try {
    for (const Mechanism& mechanism : mechanisms_)
      for (std::size_t p = 0; mechanism.law->counts_cycles() && p < n_points_; ++p)
        mechanism.law->add_cycle(cycles[p], mechanism.internal.of(of_point(p, state)));
  } catch (const ModelError& error) {
    throw ModelError(fmt::format("material '{}': {}", body_.material().name, error.what()));
  }
}

std::vector<double> MaterialPoints::evaluate(const material::StateVariable& variable, const PointsState& at) const {
  const std::size_t width = variable.width();
  const bool sums = variable.of_several == material::StateVariable::OfSeveralLaws::sum;
  std::vector<double> values(width * n_points_, 0.0);
  numerics::for_each_index(n_points_, numerics::parallel_points, [&](std::size_t p) {
    std::array<double, 6> of_law;
    const SeenStress seen(*this, p, tensor::view(at.stress, p));
    for (const Mechanism& mechanism : mechanisms_) {
      if (!mechanism.law->evaluate(variable, state_for(mechanism, p, at, seen), of_law)) continue;
      for (std::size_t k = 0; k < width; ++k) {
        double& value = values[width * p + k];
        value = sums ? value + of_law[k] : std::max(value, of_law[k]);
      }
    }
  });
  return values;
}

double MaterialPoints::stiffest_at(std::size_t p, const PointsState& at, Eigen::VectorXd& v,
                                   Eigen::VectorXd& product) const {
  constexpr int iterations = 12;
  v.setOnes();
  double size = 0;
  for (int i = 0; i < iterations; ++i) {
    v.normalize();
    const Tensor6 change = -at.elastic.stress(p, v.head<6>());
    derivative_at(p, at, {.stress = {change.data(), 6}, .state = {v.data(), stride_}}, {product.data(), stride_});
    size = product.norm();
    if (!(size > 0)) return 0;
    v.swap(product);
  }
  return size;
}

double MaterialPoints::stiffest_rate(const PointsState& given,
                                     std::span<const material::StressTangent> tangents) const {
  double stiffest = 0;
  const bool is_uniform = this->is_uniform(given);
  PointsState at = given;
  const auto prepared = has_closed_form() ? std::vector<std::vector<double>>() : prepare(at, true);
  at.prepared = &prepared;
#pragma omp parallel reduction(max : stiffest) if (n_points_ >= numerics::parallel_points)
  {
    Eigen::VectorXd v(stride_), product(stride_);
#pragma omp for schedule(static)
    for (std::size_t p = 0; p < n_points_; ++p) {
      const material::StressTangent& part = tangents[p];
      const material::Moduli& moduli = at.elastic.at(p);
      stiffest = std::max({stiffest, 2 * moduli.mu * (part.deviatoric + std::max(part.radial, 0.0)),
                           (3 * moduli.lambda + 2 * moduli.mu) * part.volumetric});
      if (!has_closed_form() && (p == 0 || !is_uniform)) stiffest = std::max(stiffest, stiffest_at(p, at, v, product));
    }
  }
  return stiffest;
}

}  // namespace creepcontact::creep
