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

TimeHardening::TimeHardening(std::string name, std::vector<Function> A, std::vector<Function> n,
                             std::vector<Function> m)
    : FlowLaw(joined({{"A", &A}, {"n", &n}, {"m", &m}})), name_(std::move(name)), n_terms_(std::ssize(A)) {}

TimeHardening::Terms TimeHardening::terms(const PointState& at) const {
  return {list_of(at.parameters, 0, n_terms_), list_of(at.parameters, 1, n_terms_),
          list_of(at.parameters, 2, n_terms_)};
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
          with_arrhenius({{"A", "creep strain at unit equivalent stress and time [1/(time^m stress^n)]", 0.0, false},
                          {"n", "stress exponent [-]", 1.0, false},
                          {"m", "time exponent [-]; below 1: primary creep", 0.0, true}}),
          [](ParameterValues p) -> std::unique_ptr<CreepLaw> {
            p = activated(std::move(p), {0});
            return std::make_unique<TimeHardening>("time_hardening", p.at(0), p.at(1), p.at(2));
          }};
}

LawInfo graham_walles_info() {
  return {
      "graham_walles", "rate = sum of A_i q^n_i m_i t^(m_i-1)", "A. Graham, K. F. A. Walles, 1955",
      with_arrhenius(
          {{.key = "A", .description = "factors [1/(time^m stress^n)]", .minimum = 0.0, .strict = false, .list = true},
           {.key = "n", .description = "stress exponents [-]", .minimum = 1.0, .strict = false, .list = true},
           {.key = "m", .description = "time exponents [-], for example 1/3, 1, 3", .minimum = 0.0, .list = true}},
          "all of A"),
      [](ParameterValues p) -> std::unique_ptr<CreepLaw> {
        p = activated(std::move(p), {0});
        return std::make_unique<TimeHardening>("graham_walles", p.at(0), p.at(1), p.at(2));
      }};
}

}  // namespace creepcontact::material
