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

/// Linear recovery where no exponents are given.
std::vector<Function> exponents_of(const std::vector<Function>& recovery, const std::vector<Function>& given) {
  return given.empty() ? std::vector<Function>(recovery.size(), 1.0) : given;
}

void require_partner(const NamedList& given, const NamedList& partner) {
  if (!given.second->empty() && partner.second->empty())
    throw ParameterError(given.first, fmt::format("values without '{}'", partner.first),
                         fmt::format("with '{}' of as many values", partner.first));
}

std::vector<Function> chaboche_parameters(const Chaboche::Constants& of) {
  std::vector<Function> all{of.K, of.n, of.yield, of.Q, of.b, of.sinh_rate};
  require_partner({"C", &of.C}, {"gamma", &of.gamma});
  require_partner({"gamma", &of.gamma}, {"C", &of.C});
  require_partner({"recovery_exponent", &of.exponent}, {"recovery", &of.recovery});
  if (of.C.empty()) return all;
  std::vector<NamedList> lists{{"C", &of.C}, {"gamma", &of.gamma}};
  if (!of.recovery.empty()) {
    lists.emplace_back("recovery", &of.recovery);
    lists.emplace_back("recovery_exponent", &of.exponent);
  }
  const std::vector<Function> joint = joined(lists);
  all.insert(all.end(), joint.begin(), joint.end());
  return all;
}

/// J of X = 2/3 C alpha
double back_stress_size(double C, const Tensor6& alpha) {
  return std::sqrt(2.0 / 3.0) * C * alpha.norm();
}

}  // namespace

Chaboche::Chaboche(const Constants& constants)
    : CreepLaw(chaboche_parameters(constants)),
      n_back_stresses_(std::ssize(constants.C)),
      recovers_(!constants.recovery.empty()),
      hardens_(!constants.Q.is_zero()) {
  if (constants.C.empty() && recovers_)
    throw ParameterError("recovery", "recovery of back stresses that are not there",
                         "'C' and 'gamma' of as many back stresses");
  if (!constants.yield.is_constant() || !constants.Q.is_constant()) return;
  const double yield = constants.yield({}), Q = constants.Q({});
  if (yield + Q < 0)
    throw ParameterError("Q", fmt::format("the number {}, which softens the yield stress {} below zero", Q, yield),
                         fmt::format("a number >= {}", -yield));
}

Chaboche::Values Chaboche::values(const PointState& at) const {
  const std::span<const double> p = at.parameters;
  Values of{.K = p[0], .n = p[1], .yield = p[2], .Q = p[3], .b = p[4], .sinh_rate = p[5]};
  if (n_back_stresses_ == 0) return of;
  const std::span<const double> lists = p.subspan(6);
  of.C = list_of(lists, 0, n_back_stresses_);
  of.gamma = list_of(lists, 1, n_back_stresses_);
  if (!recovers_) return of;
  of.recovery = list_of(lists, 2, n_back_stresses_);
  of.exponent = list_of(lists, 3, n_back_stresses_);
  return of;
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
  return {"chaboche",
          "rate = <(J(s-X) - yield - R)/K>^n, dX_i = 2/3 C_i d eps - gamma_i X_i dp, dR = b (Q-R) dp",
          "J.-L. Chaboche, 1989 and 2008",
          {{"K", "viscous resistance [stress time^(1/n)]; with sinh_rate [stress]", 0.0, true},
           {"n", "exponent of the overstress [-]", 1.0, false},
           {"yield", "size of the elastic range at first [stress]", 0.0, false},
           {.key = "Q",
            .description = "isotropic hardening R at saturation; negative: softening [stress]",
            .minimum = any,
            .strict = false,
            .fallback = {{0.0}}},
           {.key = "b",
            .description = "rate of the isotropic hardening, per inelastic strain [-]",
            .strict = false,
            .fallback = {{0.0}}},
           {.key = "C",
            .description = "moduli C_i of the back stresses [stress]; not given: no kinematic hardening",
            .strict = false,
            .list = true,
            .fallback = std::vector<Function>{}},
           {.key = "gamma",
            .description = "dynamic recovery gamma_i of the back stresses [-]; each saturates at C_i/gamma_i",
            .strict = false,
            .list = true,
            .fallback = std::vector<Function>{}},
           {.key = "recovery",
            .description = "static recovery r_i: dX_i/dt = -r_i J(X_i)^(m_i-1) X_i [1/(time stress^(m_i-1))]",
            .strict = false,
            .list = true,
            .fallback = std::vector<Function>{}},
           {.key = "recovery_exponent",
            .description = "exponents m_i of the static recovery [-]; not given: 1, linear",
            .minimum = 1.0,
            .strict = false,
            .list = true,
            .fallback = std::vector<Function>{}},
           {.key = "sinh_rate",
            .description = "if given: rate = sinh_rate sinh(overstress/K)^n instead of the power law [1/time]",
            .strict = false,
            .fallback = {{0.0}}}},
          [](ParameterValues p) -> std::unique_ptr<CreepLaw> {
            return std::make_unique<Chaboche>(
                Chaboche::Constants{p.at(0).at(0), p.at(1).at(0), p.at(2).at(0), p.at(3).at(0), p.at(4).at(0), p.at(5),
                                    p.at(6), p.at(7), exponents_of(p.at(7), p.at(8)), p.at(9).at(0)});
          },
          {&back_stress, &isotropic_hardening, &accumulated_inelastic_strain}};
}

}  // namespace creepcontact::material
