#include "expression_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "coaxial.hpp"

namespace creepcontact::material {
namespace {

constexpr double step = 3e-6;  // of central differences, relative: their error and that of rounding are 1e-10

/// What ExpressionLaw::prepare() finds, by its place: f, and the members of HardeningRate.
enum Prepared { prepared_rate, prepared_mean, prepared_by_stress, prepared_by_strain };

/// Exponent p of a power law through two points.
double slope(double near, double far, double value_near, double value_far) {
  const double p = std::log(value_far / value_near) / std::log(far / near);
  return std::isfinite(p) ? p : 0.0;
}

bool infinite_or_undefined(double rate) {
  return !std::isfinite(rate);
}

// Gauss and Legendre on (0, 1)
constexpr std::array<double, 3> gauss_place{0.11270166537925831, 0.5, 0.88729833462074169};
constexpr std::array<double, 3> gauss_weight{5.0 / 18, 8.0 / 18, 5.0 / 18};

}  // namespace

ExpressionLaw::ExpressionLaw(const ParameterValues& values)
    : HardeningLaw({}, values[rate_expression].at(0).depends_on_strain()), rate_(values[rate_expression].at(0)) {}

double ExpressionLaw::value(double q, double eps, double t, double T) const {
  return rate_({.t = t, .T = T, .q = q, .eps = eps});
}

double ExpressionLaw::equivalent_rate(double q, double eps, const PointState& at) const {
  const double f = !at.prepared.empty() ? at.prepared[prepared_rate] : value(q, eps, at.time, at.temperature);
  return f >= 0.0 ? f : std::numeric_limits<double>::quiet_NaN();
}

HardeningRate ExpressionLaw::linearized_rate(double q, double eps, const PointState& at) const {
  const auto f = [&](double stress, double strain) { return value(stress, strain, at.time, at.temperature); };
  HardeningRate result;
  if (!at.prepared.empty())
    return {at.prepared[prepared_mean], at.prepared[prepared_by_stress], at.prepared[prepared_by_strain]};
  const double above = f(q * (1 + step), eps), below = f(q * (1 - step), eps);
  result.value = 0.5 * (above + below);
  result.by_stress = (above - below) / (2 * step * q);
  if (n_internal() > 0) result.by_strain = (f(q, eps * (1 + step)) - f(q, eps * (1 - step))) / (2 * step * eps);
  return result;
}

std::vector<double> ExpressionLaw::prepare(std::span<const PointState> at, bool with_derivatives) const {
  const BatchedFunction& batch = *rate_.batch();
  const std::size_t n = at.size();
  std::vector<Arguments> here(n);
  for (std::size_t p = 0; p < n; ++p) {
    const double q = deviator(at[p].stress).q;
    here[p] = {.t = at[p].time, .T = at[p].temperature, .q = q > 0 ? q : vanishing_stress, .eps = strain(at[p])};
  }
  std::vector<double> prepared(n_prepared() * n), values(n), others(n);
  const auto set = [&](Prepared column, const auto& of_point) {
    for (std::size_t p = 0; p < n; ++p) prepared[n_prepared() * p + column] = of_point(p);
  };
  batch.evaluate(here, values);
  set(prepared_rate, [&](std::size_t p) { return values[p]; });
  if (!with_derivatives) return prepared;
  set(prepared_mean, [&](std::size_t p) { return values[p]; });
  std::vector<double> by_strain(n);
  if (batch.differentiate(here, values, by_strain)) {
    set(prepared_by_stress, [&](std::size_t p) { return values[p]; });
    set(prepared_by_strain, [&](std::size_t p) { return by_strain[p]; });
    return prepared;
  }
  const auto shifted = [&](double Arguments::*member, double factor, std::vector<double>& into) {
    std::vector<Arguments> there = here;
    for (Arguments& one : there) one.*member *= factor;
    batch.evaluate(there, into);
  };
  shifted(&Arguments::q, 1 + step, values);
  shifted(&Arguments::q, 1 - step, others);
  set(prepared_mean, [&](std::size_t p) { return 0.5 * (values[p] + others[p]); });
  set(prepared_by_stress, [&](std::size_t p) { return (values[p] - others[p]) / (2 * step * here[p].q); });
  if (n_internal() == 0) return prepared;
  shifted(&Arguments::eps, 1 + step, values);
  shifted(&Arguments::eps, 1 - step, others);
  set(prepared_by_strain, [&](std::size_t p) { return (values[p] - others[p]) / (2 * step * here[p].eps); });
  return prepared;
}

ExpressionLaw::Singularity ExpressionLaw::singularity(double q, const PointState& at) const {
  const double T = at.temperature;
  Singularity found;
  // Away from the other singularity, if there is one.
  const double t = at.time > 0.0 ? at.time : 1.0, strain = 1e-3;
  if (at.time == 0.0 && rate_.depends_on_time() && infinite_or_undefined(value(q, strain, 0.0, T))) {
    const double near = 1e-110, far = 1e-100;
    const double p = slope(near, far, value(q, strain, near, T), value(q, strain, far, T));
    if (p > -1.0 && p < -1e-6) found.time = p;
  }
  if (n_internal() > 0 && infinite_or_undefined(value(q, 0.0, t, T))) {
    const double near = at.min_strain, far = 10 * at.min_strain;
    const double p = slope(near, far, value(q, near, t, T), value(q, far, t, T));
    if (p < -1e-6) found.strain = p;
  }
  return found;
}

double ExpressionLaw::start_exponent(const PointState& at) const {
  const double q = deviator(at.stress).q;
  return q > 0.0 ? singularity(q, at).exponent() : 1.0;
}

double ExpressionLaw::accumulated(double q, double eps, const PointState& at, double duration) const {
  const Singularity power = singularity(q, at);
  // Integrated in u = (t - t0)^a, in which a rate like (t - t0)^(a-1) is constant; the strain where the rate is taken
  // is the mean, found by iteration.
  const double a = 1 + power.time, b = 1 - power.strain;
  const auto grown = [&](double end) {
    double integral = 0;
    const double strain = std::max(0.5 * (eps + end), at.min_strain);
    for (std::size_t i = 0; i < gauss_place.size(); ++i) {
      const double since = duration * std::pow(gauss_place[i], 1 / a);
      integral += gauss_weight[i] * std::pow(gauss_place[i], 1 / a - 1) / a * duration *
                  value(q, strain, at.time + since, at.temperature);
    }
    // d eps/dt = c eps^(1-b) with c of the strain where the rate was taken
    return std::pow(std::pow(eps, b) + b * std::pow(strain, b - 1) * integral, 1 / b);
  };
  double end = eps;
  const int rounds = n_internal() > 0 ? 20 : 1;
  for (int i = 0; i < rounds; ++i) {
    const double before = end;
    end = grown(before);
    if (std::abs(end - before) <= 1e-14 * end) break;
  }
  return end - eps;
}

LawInfo expression_info() {
  return {
      "expression",
      "rate = an expression in q, T, t, eps",
      "yours",
      law_table(Row<ExpressionLaw::rate_expression>{
          {.key = "rate",
           .description = "equivalent creep rate, an expression in the von Mises stress q, temperature T, time t and "
                          "accumulated equivalent creep strain eps [1/time]",
           .dimension = unit::per_time,
           .strict = false,
           .variables = {"q", "T", "t", "eps"}}}),
      construct<ExpressionLaw>,
      {&hardening_strain}};
}

}  // namespace creepcontact::material
