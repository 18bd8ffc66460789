#include "time_hardening.hpp"

#include <algorithm>

#include "arrhenius.hpp"
#include "coaxial.hpp"
#include "lists.hpp"
#include "power.hpp"

namespace creepcontact::material {
namespace {

/// (t + d)^m - t^m, also where d is far below t.
double growth(double t, double d, double m) {
  return t > 0.0 ? std::pow(t, m) * std::expm1(m * std::log1p(d / t)) : std::pow(d, m);
}

}  // namespace

TimeHardening::TimeHardening(std::string name, const ParameterValues& values)
    : FlowLaw(first(values, power_law::n_constants)),
      name_(std::move(name)),
      n_terms_(std::ssize(values[power_law::A])) {
  require_one_length({{"A", &values[power_law::A]}, {"n", &values[power_law::n]}, {"m", &values[power_law::m]}});
}

TimeHardening::Terms TimeHardening::terms(const PointState& at) const {
  return {list(power_law::A, at), list(power_law::n, at), list(power_law::m, at)};
}

EquivalentRate TimeHardening::equivalent_rate(double q, const PointState& at) const {
  const auto [A, n, m] = terms(at);
  EquivalentRate sum;
  for (Index i = 0; i < n_terms_; ++i) {
    if (A[i] == 0.0) continue;  // not 0 * infinity at t = 0
    const double secant = A[i] * m[i] * std::pow(at.time, m[i] - 1.0) * power(q, n[i] - 1.0);
    sum.value += secant * q;
    sum.slope += n[i] * secant;
  }
  return sum;
}

double TimeHardening::start_exponent(const PointState& at) const {
  if (at.time != 0.0) return 1.0;
  const auto [A, n, m] = terms(at);
  double exponent = 1.0;
  for (Index i = 0; i < n_terms_; ++i)
    if (A[i] > 0.0) exponent = std::min(exponent, m[i]);
  return exponent;
}

void TimeHardening::increment(const PointState& at, double duration, PointIncrement into) const {
  const Deviator now = deviator(at.stress);
  if (now.q == 0.0) return;
  const auto [A, n, m] = terms(at);
  double sum = 0;
  for (int i = 0; i < n_terms_; ++i) sum += A[i] * power(now.q, n[i]) * growth(at.time, duration, m[i]);
  add_flow(now, sum, into.creep_strain);
}

LawInfo time_hardening_info() {
  return {"time_hardening", "rate = A q^n m t^(m-1)", "P. G. McVetty, 1934; flow theory",
          with_arrhenius(law_table(
              Row<power_law::A>{power_law::factor()}, Row<power_law::n>{stress_exponent()},
              Row<power_law::m>{
                  {.key = "m", .description = "time exponent [-]; below 1: primary creep", .dimension = unit::none}})),
          [](const ParameterValues& values) -> std::unique_ptr<CreepLaw> {
            return std::make_unique<TimeHardening>("time_hardening", values);
          }};
}

LawInfo graham_walles_info() {
  return {"graham_walles", "rate = sum of A_i q^n_i m_i t^(m_i-1)", "A. Graham, K. F. A. Walles, 1955",
          with_arrhenius(law_table(Row<power_law::A>{{.key = "A",
                                                      .description = "factors [1/(time^m stress^n)]",
                                                      .dimension = power_law::factor().dimension,
                                                      .strict = false,
                                                      .list = true,
                                                      .activation = Activation::rate}},
                                   Row<power_law::n>{{.key = "n",
                                                      .description = "stress exponents [-]",
                                                      .dimension = unit::none,
                                                      .minimum = 1.0,
                                                      .strict = false,
                                                      .list = true}},
                                   Row<power_law::m>{{.key = "m",
                                                      .description = "time exponents [-], for example 1/3, 1, 3",
                                                      .dimension = unit::none,
                                                      .list = true}})),
          [](const ParameterValues& values) -> std::unique_ptr<CreepLaw> {
            return std::make_unique<TimeHardening>("graham_walles", values);
          }};
}

}  // namespace creepcontact::material
