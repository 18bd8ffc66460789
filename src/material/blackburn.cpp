#include "blackburn.hpp"

#include <algorithm>

#include "arrhenius.hpp"
#include "hardening_law.hpp"

namespace creepcontact::material {
namespace {

ParameterValues with_transient(ParameterValues values) {
  if (values[Blackburn::beta_r].empty()) values[Blackburn::beta_r] = values[Blackburn::beta];
  if (values[Blackburn::n_r].empty()) values[Blackburn::n_r] = values[Blackburn::n];
  return first(values, Blackburn::s_min);
}

/// Strain of a transient at constant stress. @param start  its rate at the start of `duration` @param speed  1/time
double transient_growth(double start, double speed, double duration) {
  const double x = speed * duration;
  return std::max(start, 0.0) * duration * (x > 0.0 ? -std::expm1(-x) / x : 1.0);
}

}  // namespace

Blackburn::Blackburn(const ParameterValues& values)
    : ScalarStateLaw(with_transient(values)), own_transient_(!values[beta_r].empty() || !values[n_r].empty()) {
  const auto number = [&](Constant constant) { return values[constant].at(0)({}); };
  s_min_ = number(s_min);
  l_ = number(l);
  threshold_ = number(threshold);
  stress_unit_ = number(stress_unit);
  strain_unit_ = number(strain_unit);
}

void Blackburn::increment(const PointState& at, double duration, PointIncrement into) const {
  const Deviator now = deviator(at.stress);
  if (now.q == 0.0) return;
  const Terms<double> of = terms(now.q, at.parameters);
  const double fast = transient_growth(of.fast * (of.fast_limit - at.internal[0]), of.fast, duration);
  const double slow = transient_growth(of.slow_start - of.slow * at.internal[1], of.slow, duration);
  add_flow(now, fast + slow + of.steady * duration, into.creep_strain);
  into.internal[0] += fast;
  into.internal[1] += slow;
}

bool Blackburn::evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const {
  if (&variable != &hardening_strain) return false;
  into[0] = at.internal[0] + at.internal[1];
  return true;
}

LawInfo blackburn_info() {
  using Law = Blackburn;
  const double any = -std::numeric_limits<double>::infinity();
  const auto number = [](const char* key, const std::string& meaning, const UnitPowers& dimension, double minimum,
                         double value) {
    return ParameterInfo{.key = key,
                         .description = meaning,
                         .dimension = dimension,
                         .minimum = minimum,
                         .strict = false,
                         .fallback = {{value}},
                         .variables = {}};
  };
  const auto scale = [](const char* key, const std::string& meaning, const UnitPowers& dimension) {
    return ParameterInfo{
        .key = key, .description = meaning, .dimension = dimension, .fallback = {{1.0}}, .variables = {}};
  };
  return {
      "blackburn",
      "strain at constant stress = ex (1 - exp(-s t)) + et (1 - exp(-r t)) + em t, em = A g, s = D g_r, r = B g_r, et "
      "= C em/r, ex = G + H sigma, g = sinh(beta sigma/n)^n",
      "L. D. Blackburn, 1972; ASME III-5 HBB",
      with_arrhenius(law_table(
          Row<Law::A>{{.key = "A",
                       .description = "factor of the steady rate em [strain_unit/time]",
                       .dimension = unit::per_time,
                       .strict = false,
                       .activation = Activation::rate}},
          Row<Law::beta>{
              {.key = "beta", .description = "inverse stress in g [1/stress_unit]", .dimension = unit::none}},
          Row<Law::n>{stress_exponent("n", "exponent of g [-]")},
          Row<Law::B>{{.key = "B",
                       .description = "factor of the rate r of the slow transient [1/time]",
                       .dimension = unit::per_time,
                       .activation = Activation::rate}},
          Row<Law::C>{{.key = "C",
                       .description = "strain of the slow transient, et = C em/r [-]",
                       .dimension = unit::none,
                       .strict = false}},
          Row<Law::D>{{.key = "D",
                       .description = "factor of the rate s of the fast transient [1/time]",
                       .dimension = unit::per_time,
                       .strict = false,
                       .activation = Activation::rate}},
          Row<Law::G>{{.key = "G",
                       .description = "strain ex of the fast transient at sigma = 0 [strain_unit]",
                       .dimension = unit::none,
                       .minimum = any,
                       .strict = false,
                       .fallback = {{0.0}}}},
          Row<Law::H>{{.key = "H",
                       .description = "its growth with sigma [strain_unit/stress_unit]; negative strains count as 0",
                       .dimension = unit::none,
                       .minimum = any,
                       .strict = false,
                       .fallback = {{0.0}}}},
          Row<Law::L>{{.key = "L",
                       .description = "r is at least L sigma^(n - l) [1/time]",
                       .dimension = unit::per_time,
                       .strict = false,
                       .fallback = {{0.0}}}},
          Row<Law::beta_r>{{.key = "beta_r",
                            .description = "beta in g_r, of both transients [1/stress_unit]; not given: `beta`",
                            .dimension = unit::none,
                            .fallback = std::vector<Function>{}}},
          Row<Law::n_r>{{.key = "n_r",
                         .description = "n in g_r [-]; not given: `n`",
                         .dimension = unit::none,
                         .minimum = 1.0,
                         .strict = false,
                         .fallback = std::vector<Function>{}}},
          Row<Law::s_min>{number("s_min", "s is at least this [1/time]", unit::per_time, 0, 0)},
          Row<Law::l>{number("l", "see `L` [-]", unit::none, any, 3.6)},
          Row<Law::threshold>{number("threshold", "sigma below which ex is 0 [stress_unit]", unit::none, 0, 0)},
          Row<Law::stress_unit>{scale("stress_unit",
                                      "unit of stress of the constants, sigma = q/stress_unit; psi in MPa: 0.00689476 "
                                      "[stress]",
                                      unit::stress)},
          Row<Law::strain_unit>{
              scale("strain_unit", "unit of strain of the constants; percent: 0.01 [-]", unit::none)})),
      construct<Law>,
      {&hardening_strain}};
}

}  // namespace creepcontact::material
