#include "chaboche.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "coaxial.hpp"
#include "lists.hpp"
#include "power.hpp"
#include "viscoplastic_variables.hpp"

namespace creepcontact::material {

struct Chaboche::Values {
  double K, n, yield, Q, b, sinh_rate;
  std::span<const double> C = {}, gamma = {}, recovery = {}, exponent = {};  ///< n_back_stresses_, or empty
};

struct Chaboche::Flow {
  Deviator xi;
  Rate rate;
  Tensor6 direction;  ///< 3/2 xi/J, or 0
};

namespace {

void require_partner(const NamedList& given, const NamedList& partner) {
  if (!given.second->empty() && partner.second->empty())
    throw ParameterError(given.first, fmt::format("values without '{}'", partner.first),
                         fmt::format("with '{}' of as many values", partner.first));
}

/// The constants with exponents of linear recovery where none are given.
ParameterValues checked(ParameterValues values) {
  if (values[Chaboche::recovery_exponent].empty())
    values[Chaboche::recovery_exponent].assign(values[Chaboche::recovery].size(), 1.0);
  const NamedList C{"C", &values[Chaboche::C]}, gamma{"gamma", &values[Chaboche::gamma]},
      recovery{"recovery", &values[Chaboche::recovery]},
      exponent{"recovery_exponent", &values[Chaboche::recovery_exponent]};
  require_partner(C, gamma);
  require_partner(gamma, C);
  require_partner(exponent, recovery);
  if (C.second->empty()) return values;
  std::vector<NamedList> lists{C, gamma};
  if (!recovery.second->empty()) lists.insert(lists.end(), {recovery, exponent});
  require_one_length(lists);
  return values;
}

/// J of X = 2/3 C alpha
double back_stress_size(double C, const Tensor6& alpha) {
  return std::sqrt(2.0 / 3.0) * C * alpha.norm();
}

}  // namespace

Chaboche::Chaboche(const ParameterValues& values)
    : CreepLaw(checked(first(values, n_constants))),
      n_back_stresses_(std::ssize(values[C])),
      recovers_(!values[recovery].empty()),
      hardens_(!values[Q].at(0).is_zero()) {
  if (n_back_stresses_ == 0 && recovers_)
    throw ParameterError("recovery", "recovery of back stresses that are not there",
                         "'C' and 'gamma' of as many back stresses");
  const Function &elastic_range = values[yield].at(0), &hardening = values[Q].at(0);
  if (!elastic_range.is_constant() || !hardening.is_constant()) return;
  const double size = elastic_range({}), growth = hardening({});
  if (size + growth < 0)
    throw ParameterError("Q", fmt::format("the number {}, which softens the yield stress {} below zero", growth, size),
                         fmt::format("a number >= {}", -size));
}

Chaboche::Values Chaboche::values(const PointState& at) const {
  const std::span<const double> p = at.parameters;
  return {.K = p[K],
          .n = p[n],
          .yield = p[yield],
          .Q = p[Q],
          .b = p[b],
          .sinh_rate = list(sinh_rate, at)[0],
          .C = list(C, at),
          .gamma = list(gamma, at),
          .recovery = list(recovery, at),
          .exponent = list(recovery_exponent, at)};
}

Chaboche::Rate Chaboche::flow_rate(const Values& of, double overstress) {
  if (!(overstress > 0.0)) return {};
  const double x = overstress / of.K;
  if (of.sinh_rate > 0.0) {
    const double below = of.sinh_rate * power(std::sinh(x), of.n - 1.0);
    return {below * std::sinh(x), of.n * below * std::cosh(x) / of.K};
  }
  const double below = power(x, of.n - 1.0);
  return {below * x, of.n * below / of.K};
}

Tensor6 Chaboche::back_stress(const Values& of, std::span<const double> internal) const {
  Tensor6 sum = Tensor6::Zero();
  for (Index i = 0; i < n_back_stresses_; ++i) sum += 2.0 / 3.0 * of.C[i] * tensor::view(internal, i);
  return sum;
}

Chaboche::Flow Chaboche::flow(const Values& of, const PointState& at) const {
  Flow now;
  const Tensor6 xi = at.stress - back_stress(of, at.internal);
  now.xi = deviator(tensor::view(xi));
  const double R = hardens_ ? of.Q * at.internal[p_index() + 1] : 0.0;
  now.rate = flow_rate(of, now.xi.q - of.yield - R);
  now.direction = now.xi.q > 0.0 ? Tensor6(1.5 / now.xi.q * now.xi.s) : Tensor6(Tensor6::Zero());
  return now;
}

void Chaboche::rate(const PointState& at, PointRate into) const {
  const Values of = values(at);
  const Flow now = flow(of, at);
  const Tensor6 strain = now.rate.value * now.direction;
  into.creep_strain += strain;
  for (Index i = 0; i < n_back_stresses_; ++i) {
    const tensor::ConstMap alpha = tensor::view(at.internal, i);
    double fading = of.gamma[i] * now.rate.value;
    if (recovers_) fading += of.recovery[i] * power(back_stress_size(of.C[i], alpha), of.exponent[i] - 1.0);
    tensor::writable(into.internal, i) = strain - fading * alpha;
  }
  into.internal[p_index()] = now.rate.value;
  if (hardens_) into.internal[p_index() + 1] = of.b * (1.0 - at.internal[p_index() + 1]) * now.rate.value;
}

void Chaboche::derivative(const PointState& at, const PointChange& change, PointRate into) const {
  const Values of = values(at);
  const Flow now = flow(of, at);
  const double J = now.xi.q;
  const Tensor6 d_xi = tensor::deviator(change.stress - back_stress(of, change.internal));
  const double d_hardening = hardens_ ? change.internal[p_index() + 1] : 0.0;
  const double d_rate = now.rate.slope * (now.direction.dot(d_xi) - of.Q * d_hardening);
  Tensor6 d_strain = d_rate * now.direction;
  if (J > 0.0) d_strain += now.rate.value / J * (1.5 * d_xi - now.direction.dot(d_xi) * now.direction);
  into.creep_strain += d_strain;
  for (Index i = 0; i < n_back_stresses_; ++i) {
    const tensor::ConstMap alpha = tensor::view(at.internal, i), d_alpha = tensor::view(change.internal, i);
    Tensor6 own = d_strain - of.gamma[i] * (now.rate.value * d_alpha + d_rate * alpha);
    if (recovers_) {
      const double exponent = of.exponent[i] - 1.0, length = alpha.norm();
      const double fading = of.recovery[i] * power(back_stress_size(of.C[i], alpha), exponent);
      own -= fading * d_alpha;
      if (length > 0.0) own -= fading * exponent * alpha.dot(d_alpha) / (length * length) * alpha;
    }
    tensor::writable(into.internal, i) = own;
  }
  into.internal[p_index()] = d_rate;
  if (hardens_)
    into.internal[p_index() + 1] = of.b * ((1.0 - at.internal[p_index() + 1]) * d_rate - now.rate.value * d_hardening);
}

StressTangent Chaboche::stress_tangent(const PointState& at) const {
  const Flow now = flow(values(at), at);
  return coaxial_tangent(now.xi.q, now.rate.value, now.rate.slope);
}

void Chaboche::increment(const PointState& at, double duration, PointIncrement into) const {
  const Values of = values(at);
  const Tensor6 s = tensor::deviator(at.stress);
  const double hardened = hardens_ ? at.internal[p_index() + 1] : 0.0;
  const auto fading = [&](Index i, double dp) {
    double sum = 1.0 + of.gamma[i] * dp;
    if (recovers_)
      sum += duration * of.recovery[i] *
             power(back_stress_size(of.C[i], tensor::view(at.internal, i)), of.exponent[i] - 1.0);
    return sum;
  };
  // xi at the end has the direction of this tensor, and its size less the hardening in this step.
  const auto trial = [&](double dp) {
    Tensor6 sum = s;
    for (Index i = 0; i < n_back_stresses_; ++i)
      sum -= 2.0 / 3.0 * of.C[i] / fading(i, dp) * tensor::view(at.internal, i);
    return sum;
  };
  const auto hardening = [&](double dp) { return (hardened + of.b * dp) / (1.0 + of.b * dp); };
  const auto growth = [&](double dp) {
    double overstress = tensor::von_mises(trial(dp)) - of.yield - of.Q * (hardens_ ? hardening(dp) : 0.0);
    for (Index i = 0; i < n_back_stresses_; ++i) overstress -= of.C[i] * dp / fading(i, dp);
    return duration * flow_rate(of, overstress).value;
  };
  // The growth falls with dp, or rises by far less than dp: halving between 0 and a dp that is more than it causes.
  double low = 0.0, high = growth(0.0);
  if (!(high > 0.0)) high = 0.0;
  if (!std::isfinite(high)) high = std::numeric_limits<double>::max() / 4;
  const bool encloses = growth(high) <= high;
  for (int i = 0; encloses && i < 2200 && high - low > 1e-12 * high; ++i) {
    // In the logarithm as long as the ends are of different size.
    const double middle = low > 0.0 && high > 4.0 * low ? std::sqrt(low) * std::sqrt(high)
                          : low > 0.0                   ? 0.5 * (low + high)
                                                        : high * (i == 0 ? 0.5 : 1e-3);
    (growth(middle) > middle ? low : high) = middle;
  }
  const double dp = high;
  const Tensor6 direction = trial(dp);
  const double size = tensor::von_mises(direction);
  const Tensor6 strain = size > 0.0 ? Tensor6(1.5 * dp / size * direction) : Tensor6(Tensor6::Zero());
  into.creep_strain += strain;
  for (Index i = 0; i < n_back_stresses_; ++i) {
    const tensor::ConstMap alpha = tensor::view(at.internal, i);
    tensor::writable(into.internal, i) += (alpha + strain) / fading(i, dp) - alpha;
  }
  into.internal[p_index()] += dp;
  if (hardens_) into.internal[p_index() + 1] += hardening(dp) - hardened;
}

bool Chaboche::evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const {
  if (&variable == &material::back_stress && n_back_stresses_ > 0)
    tensor::writable(into, 0) = back_stress(values(at), at.internal);
  else if (&variable == &isotropic_hardening && hardens_)
    into[0] = values(at).Q * at.internal[p_index() + 1];
  else if (&variable == &accumulated_inelastic_strain)
    into[0] = at.internal[p_index()];
  else
    return false;
  return true;
}

LawInfo chaboche_info() {
  const double any = -std::numeric_limits<double>::infinity();
  return {
      "chaboche",
      "rate = <(J(s-X) - yield - R)/K>^n, dX_i = 2/3 C_i d eps - gamma_i X_i dp, dR = b (Q-R) dp",
      "J.-L. Chaboche, 1989 and 2008",
      law_table(
          Row<Chaboche::K>{
              {.key = "K",
               .description = "viscous resistance [stress time^(1/n)]; with sinh_rate [stress]",
               .dimension = unit::stress * unit::pow(unit::time, reciprocal(Chaboche::n).unless(Chaboche::sinh_rate))}},
          Row<Chaboche::n>{{.key = "n",
                            .description = "exponent of the overstress [-]",
                            .dimension = unit::none,
                            .minimum = 1.0,
                            .strict = false}},
          Row<Chaboche::yield>{{.key = "yield",
                                .description = "size of the elastic range at first [stress]",
                                .dimension = unit::stress,
                                .strict = false}},
          Row<Chaboche::Q>{{.key = "Q",
                            .description = "isotropic hardening R at saturation; negative: softening [stress]",
                            .dimension = unit::stress,
                            .minimum = any,
                            .strict = false,
                            .fallback = {{0.0}}}},
          Row<Chaboche::b>{{.key = "b",
                            .description = "rate of the isotropic hardening, per inelastic strain [-]",
                            .dimension = unit::none,
                            .strict = false,
                            .fallback = {{0.0}}}},
          Row<Chaboche::C>{
              {.key = "C",
               .description = "moduli C_i of the back stresses [stress]; not given: no kinematic hardening",
               .dimension = unit::stress,
               .strict = false,
               .list = true,
               .fallback = std::vector<Function>{}}},
          Row<Chaboche::gamma>{
              {.key = "gamma",
               .description = "dynamic recovery gamma_i of the back stresses [-]; each saturates at C_i/gamma_i",
               .dimension = unit::none,
               .strict = false,
               .list = true,
               .fallback = std::vector<Function>{}}},
          Row<Chaboche::recovery>{
              {.key = "recovery",
               .description = "static recovery r_i: dX_i/dt = -r_i J(X_i)^(m_i-1) X_i [1/(time stress^(m_i-1))]",
               .dimension = unit::per_time * unit::stress / unit::pow(unit::stress, Chaboche::recovery_exponent),
               .strict = false,
               .list = true,
               .fallback = std::vector<Function>{}}},
          Row<Chaboche::recovery_exponent>{
              {.key = "recovery_exponent",
               .description = "exponents m_i of the static recovery [-]; not given: 1, linear",
               .dimension = unit::none,
               .minimum = 1.0,
               .strict = false,
               .list = true,
               .fallback = std::vector<Function>{}}},
          Row<Chaboche::sinh_rate>{
              {.key = "sinh_rate",
               .description = "if given: rate = sinh_rate sinh(overstress/K)^n instead of the power law [1/time]",
               .dimension = unit::per_time,
               .strict = false,
               .fallback = {{0.0}}}}),
      construct<Chaboche>,
      {&back_stress, &isotropic_hardening, &accumulated_inelastic_strain}};
}

}  // namespace creepcontact::material
