#include "verification/plastic_point.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace creepcontact::test {
namespace {

double size_of(const Tensor6& deviator) {
  return std::sqrt(1.5) * deviator.norm();
}

}  // namespace

PlasticPath::PlasticPath(PlasticRates law) : law_(std::move(law)) {
  const double mu = law_.young_modulus / (2 * (1 + law_.poisson_ratio));
  const double lambda = 2 * mu * law_.poisson_ratio / (1 - 2 * law_.poisson_ratio);
  elasticity_ = 2 * mu * Matrix6::Identity() + lambda * tensor::identity() * tensor::identity().transpose();
  now_.back.assign(law_.back.size(), Tensor6::Zero());
}

Tensor6 PlasticPath::relative_stress(const State& at) const {
  Tensor6 result = tensor::deviator(at.stress);
  for (const Tensor6& X : at.back) result -= X;
  return result;
}

PlasticPath::State PlasticPath::rate(const State& at, const Way& way, bool yields) const {
  const Tensor6 relative = relative_stress(at), N = relative / size_of(relative);
  const Tensor6 drive = 1.5 * elasticity_ * N;  // of stress per dp, without its sign
  double resistance = 1.5 * N.dot(drive) + law_.hardening_modulus;
  for (std::size_t i = 0; i < at.back.size(); ++i)
    resistance += 1.5 * N.dot(law_.back[i].first * N - law_.back[i].second * at.back[i]);
  Matrix6 moduli = elasticity_;
  if (yields) moduli -= drive * drive.transpose() / resistance;

  Matrix6 conditions;
  Tensor6 values = Tensor6::Zero();
  Eigen::Index row = 0;
  for (const auto& [d, value] : way.strain) {
    values[row] = value;
    conditions.row(row++) = d.transpose();
  }
  for (const Tensor6& d : way.free) conditions.row(row++) = d.transpose() * moduli;
  for (Eigen::Index shear = 5; row < 6; --shear) conditions.row(row++) = Tensor6::Unit(shear).transpose();

  State result;
  result.strain = conditions.partialPivLu().solve(values);
  result.stress = moduli * result.strain;
  result.p = yields ? drive.dot(result.strain) / resistance : 0;
  result.back.assign(at.back.size(), Tensor6::Zero());
  for (std::size_t i = 0; yields && i < at.back.size(); ++i)
    result.back[i] = result.p * (law_.back[i].first * N - law_.back[i].second * at.back[i]);
  return result;
}

PlasticPath::State PlasticPath::moved(const State& from, const State& rate, double length) {
  State result = from;
  result.strain += length * rate.strain;
  result.stress += length * rate.stress;
  result.p += length * rate.p;
  for (std::size_t i = 0; i < from.back.size(); ++i) result.back[i] += length * rate.back[i];
  return result;
}

double PlasticPath::part_to_yield(const Way& way) const {
  const Tensor6 from = relative_stress(now_), along = tensor::deviator(rate(now_, way, false).stress);
  const double yield = yield_stress(now_);
  const double a = 1.5 * along.squaredNorm(), b = 1.5 * from.dot(along), c = 1.5 * from.squaredNorm() - yield * yield;
  return (-b + std::sqrt(std::max(0.0, b * b - a * std::min(c, 0.0)))) / a;
}

void PlasticPath::follow(const Way& way, int n_steps) {
  constexpr double on_surface = 1e-9, neutral = -1e-12;
  for (double left = 1; left > 0;) {
    const bool may_yield = size_of(relative_stress(now_)) > (1 - on_surface) * yield_stress(now_);
    if (!may_yield || rate(now_, way, true).p < neutral) {
      const double part = std::min(left, part_to_yield(way));
      now_ = moved(now_, rate(now_, way, false), part);
      left -= part;
      continue;
    }
    const double h = std::min(left, 1.0 / n_steps);
    const State k1 = rate(now_, way, true), k2 = rate(moved(now_, k1, h / 2), way, true),
                k3 = rate(moved(now_, k2, h / 2), way, true), k4 = rate(moved(now_, k3, h), way, true);
    for (const auto& [k, weight] : {std::pair{&k1, 1.0 / 6}, {&k2, 1.0 / 3}, {&k3, 1.0 / 3}, {&k4, 1.0 / 6}})
      now_ = moved(now_, *k, weight * h);
    left -= h;
  }
}

}  // namespace creepcontact::test
