#include "time_transformed_system.hpp"

#include <cmath>

#include "elementwise.hpp"

namespace creepcontact::ode {

double TimeTransformedSystem::s(double t) const {
  return exponent_ == 1 ? t : std::pow(t - begin_, exponent_);
}

double TimeTransformedSystem::t(double s) const {
  if (exponent_ == 1) return s;
  if (s == s_limit_) return t_limit_;
  return begin_ + std::pow(s, 1 / exponent_);
}

double TimeTransformedSystem::speed(double s) const {
  return exponent_ == 1 ? 1 : std::pow(s, 1 / exponent_ - 1) / exponent_;
}

void TimeTransformedSystem::rate(double s, std::span<const double> y, std::span<double> rate) {
  system_.rate(t(s), y, rate);
  const double factor = speed(s);
  for_each_index(rate.size(), [&](std::size_t i) { rate[i] *= factor; });
}

void TimeTransformedSystem::jacobian_times(double s, std::span<const double> y, std::span<const double> v,
                                           std::span<double> product) {
  system_.jacobian()->jacobian_times(t(s), y, v, product);
  const double factor = speed(s);
  for_each_index(product.size(), [&](std::size_t i) { product[i] *= factor; });
}

void TimeTransformedSystem::prepare_preconditioner(double s, std::span<const double> y) {
  system_.jacobian()->prepare_preconditioner(t(s), y);
  prepared_speed_ = speed(s);
}

double TimeTransformedSystem::stable_step(double s, std::span<const double> y) {
  const double stable = system_.stable_step(t(s), y);
  if (exponent_ == 1 || std::isinf(stable)) return stable;
  const double elapsed = std::pow(s, 1 / exponent_);
  return std::pow(elapsed + stable, exponent_) - s;
}

}  // namespace creepcontact::ode
