#include "creepcontact/heat/rate_form.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "kept_factor.hpp"

namespace creepcontact::heat {
namespace {

constexpr double rounding = 1e-14;   // of solutions with C, which must not depend on what has been factored
constexpr double difference = 1e-4;  // of the largest temperature, pressure and gap, in central differences
constexpr double same_gamma = 1.25;

using Vector = Eigen::VectorXd;
using ConstMap = Eigen::Map<const Vector>;
using Map = Eigen::Map<Vector>;

ConstMap vector(std::span<const double> values) {
  return {values.data(), std::ssize(values)};
}
Map vector(std::span<double> values) {
  return {values.data(), std::ssize(values)};
}

double largest(std::span<const double> values) {
  return values.empty() ? 0 : vector(values).cwiseAbs().maxCoeff();
}

/// base + factor change, not below zero
std::vector<double> moved(std::span<const double> base, std::span<const double> change, double factor) {
  std::vector<double> result(base.begin(), base.end());
  for (std::size_t i = 0; i < change.size(); ++i) result[i] = std::max(0.0, result[i] + factor * change[i]);
  return result;
}

/// The change of what `evaluate(T, contact, into)` gives, by a central difference.
/// @param T_change  empty: none
template <typename Evaluate>
void central_difference(std::span<const double> T, std::span<const double> T_change, const ContactAtNodes& contact,
                        const ContactAtNodes& contact_change, std::span<double> change, const Evaluate& evaluate) {
  double factor = std::numeric_limits<double>::infinity();
  const auto bound = [&](std::span<const double> of, std::span<const double> by) {
    const double most = largest(by);
    if (most > 0) factor = std::min(factor, difference * std::max(largest(of), difference * most) / most);
  };
  bound(T, T_change);
  bound(contact.pressure, contact_change.pressure);
  bound(contact.gap, contact_change.gap);
  std::ranges::fill(change, 0.0);
  if (!std::isfinite(factor)) return;
  std::vector<double> side(change.size());
  for (const double sign : {1.0, -1.0}) {
    std::vector<double> at(T.begin(), T.end());
    for (std::size_t u = 0; u < T_change.size(); ++u) at[u] += sign * factor * T_change[u];
    const std::vector<double> pressure = moved(contact.pressure, contact_change.pressure, sign * factor),
                              gap = moved(contact.gap, contact_change.gap, sign * factor);
    evaluate(at, ContactAtNodes{pressure, gap}, side);
    for (std::size_t u = 0; u < change.size(); ++u) change[u] += sign * side[u] / (2 * factor);
  }
}

/// @throws ModelError if the matrix is singular
void solve(KeptFactor& factor, std::span<double> x) {
  try {
    factor.solve(x, {rounding, 0});
  } catch (const linalg::SingularMatrix&) {
    throw ModelError("heat: the heat capacity of a body is zero, or nothing holds its temperature");
  }
}

}  // namespace

RateForm::RateForm(const Definition& definition)
    : problem_(definition),
      capacity_(std::make_unique<KeptFactor>()),
      both_(std::make_unique<KeptFactor>()),
      steady_(std::make_unique<KeptFactor>()) {}
RateForm::~RateForm() = default;

void RateForm::solve_capacity(double t, std::span<const double> T, std::span<double> x) {
  if (!has_capacity_ || !problem_.has_constant_capacity()) {
    capacity_matrix_ = problem_.matrix(t, T, {}, 0, 1);
    capacity_->set(capacity_matrix_);
    has_capacity_ = true;
  }
  solve(*capacity_, x);
}

void RateForm::rate(double t, std::span<const double> T, const ContactAtNodes& contact, std::span<double> rate) {
  problem_.inflow(t, T, contact, rate);
  solve_capacity(t, T, rate);
  for (std::size_t u = 0; u < size(); ++u)
    if (problem_.is_given(u)) rate[u] = problem_.given_rate(u, t);
}

void RateForm::derivative(double t, std::span<const double> T, const ContactAtNodes& contact,
                          std::span<const double> T_change, const ContactAtNodes& contact_change,
                          std::span<double> product) {
  central_difference(T, T_change, contact, contact_change, product,
                     [&](std::span<const double> at, const ContactAtNodes& there, std::span<double> side) {
                       rate(t, at, there, side);
                     });
  for (std::size_t u = 0; u < size(); ++u)
    if (problem_.is_given(u)) product[u] = 0;
}

void RateForm::prepare(double t, std::span<const double> T, const ContactAtNodes& contact) {
  prepared_capacity_ = problem_.matrix(t, T, contact, 0, 1);
  prepared_conduction_ = problem_.matrix(t, T, contact, 1, 0);
  gamma_ = 0;
}

void RateForm::precondition(double gamma, std::span<const double> r, std::span<double> z) {
  const bool prepared = gamma < same_gamma * gamma_ && gamma_ < same_gamma * gamma;
  if (!prepared) {
    both_matrix_ = prepared_capacity_ + gamma * prepared_conduction_;
    both_->set(both_matrix_);
    both_->factorize();
    gamma_ = gamma;
  }
  vector(z) = prepared_capacity_.selfadjointView<Eigen::Lower>() * vector(r);
  for (std::size_t u = 0; u < size(); ++u)
    if (problem_.is_given(u)) z[u] = 0;
  solve(*both_, z);
  for (std::size_t u = 0; u < size(); ++u)
    if (problem_.is_given(u)) z[u] = r[u];
}

std::optional<std::vector<double>> RateForm::steady_change(double t, std::span<const double> T,
                                                           const ContactAtNodes& contact,
                                                           const ContactAtNodes& contact_change) {
  std::vector<double> result(size());
  central_difference(T, {}, contact, contact_change, result,
                     [&](std::span<const double> at, const ContactAtNodes& there, std::span<double> side) {
                       problem_.inflow(t, at, there, side);
                     });
  steady_matrix_ = problem_.matrix(t, T, contact, 1, 0);
  steady_->set(steady_matrix_);
  try {
    steady_->solve(result, {rounding, 0});
  } catch (const linalg::SingularMatrix&) {
    return std::nullopt;
  }
  return result;
}

}  // namespace creepcontact::heat
