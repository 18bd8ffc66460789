#include "rcc_mr.hpp"

#include <algorithm>
#include <limits>

#include "arrhenius.hpp"
#include "constant_parameter.hpp"
#include "power.hpp"

namespace creepcontact::material {

namespace {

constexpr double rcc_mr_decline = 20;  // exponent of the strain with which the rate falls after primary creep

}  // namespace

/// All stages at one stress, of virgin material: primary creep up to the time `end`, then a rate
/// end_rate (eps/end_strain)^-k down to the secondary one.
struct RccMr::Stages {
  Stages(double q, const PointState& at)
      : C2(at.parameters[Constant::C2]),
        n1(at.parameters[Constant::n1]),
        n(at.parameters[Constant::n]),
        primary(at.parameters[C1] * power(q, n1)),
        secondary(at.parameters[C] * power(q, n)) {
    const double C3 = at.parameters[Constant::C3];
    constexpr double never = std::numeric_limits<double>::infinity();
    if (secondary == 0.0 || (C2 == 1.0 && primary >= secondary))
      end = never;
    else if (C2 < 1.0)
      end = std::pow(C2 * primary / secondary, 1.0 / (1.0 - C2));  // both rates are equal
    secondary_strain = end_strain = primary > 0.0 ? primary * std::pow(end, C2) : 0.0;
    if (!(C3 > 0.0) || !(primary > 0.0)) return;
    n3 = at.parameters[Constant::n3];
    const double given = C3 * std::pow(q, n3);
    if (given >= end) return;
    end = given;
    end_strain = primary * std::pow(end, C2);
    end_rate = C2 * end_strain / end;
    secondary_strain = end_strain * std::pow(end_rate / secondary, 1.0 / rcc_mr_decline);
  }

  double rate(double eps) const {
    if (eps >= secondary_strain) return secondary;
    if (eps >= end_strain) return end_rate * std::pow(eps / end_strain, -rcc_mr_decline);
    return C2 * primary * std::pow(primary / eps, 1.0 / C2 - 1.0);
  }

  /// Growth in this duration, at least 0, of a strain eps.
  double growth(double eps, double duration) const {
    double grown = 0;
    if (eps < end_strain) {
      const double before = std::pow(eps / primary, 1.0 / C2);  // when virgin material has this strain
      const double part = std::min(duration, end - before);
      grown = eps > 0.0 ? eps * std::expm1(C2 * std::log1p(part / before)) : primary * std::pow(part, C2);
      duration -= part;
    }
    if (duration <= 0.0) return grown;
    if (eps + grown < secondary_strain) {
      // d(x^(k+1))/dt is constant, x = eps/end_strain
      constexpr double k = rcc_mr_decline;
      const double x = std::max((eps + grown) / end_strain, 1.0), y = std::pow(x, k + 1.0);
      const double speed = (k + 1.0) * end_rate / end_strain;
      const double part = std::min(duration, (std::pow(secondary_strain / end_strain, k + 1.0) - y) / speed);
      grown += end_strain * x * std::expm1(std::log1p(speed * part / y) / (k + 1.0));
      duration -= part;
    }
    return grown + secondary * duration;
  }

  double C2, n1, n, n3 = 0;
  double primary;    ///< strain after a unit of time
  double secondary;  ///< rate
  double end = 0, end_strain = 0, end_rate = 0;
  double secondary_strain = 0;  ///< from which on creep is secondary
};

RccMr::RccMr(const ParameterValues& values) : HardeningLaw(first(values, n_constants), true) {
  require_constant("C2", parameters()[C2], 0.0, 1.0);
}

double RccMr::equivalent_rate(double q, double eps, const PointState& at) const {
  return Stages(q, at).rate(eps);
}

HardeningRate RccMr::linearized_rate(double q, double eps, const PointState& at) const {
  const Stages stages(q, at);
  const double f = stages.rate(eps);
  if (eps >= stages.secondary_strain) return {f, f * stages.n / q, 0.0};
  if (eps >= stages.end_strain) {
    const double of_strain = stages.n1 + stages.C2 * stages.n3;  // exponents of q in end_strain, end_rate
    return {f, f * (of_strain - stages.n3 + rcc_mr_decline * of_strain) / q, -f * rcc_mr_decline / eps};
  }
  return {f, f * stages.n1 / (stages.C2 * q), f * (1.0 - 1.0 / stages.C2) / eps};
}

double RccMr::accumulated(double q, double eps, const PointState& at, double duration) const {
  return Stages(q, at).growth(eps, duration);
}

double RccMr::start_exponent(const PointState& at) const {
  return at.parameters[C1] > 0.0 ? at.parameters[C2] : 1.0;
}

LawInfo rcc_mr_info() {
  const double any = -std::numeric_limits<double>::infinity();
  return {
      "rcc_mr",
      "strain at constant stress = C1 q^n1 t^C2 up to t_fp = C3 q^n3 or the rate C q^n, then rate = C q^n",
      "AFCEN, RCC-MR, Appendix A3",
      with_arrhenius(law_table(
          Row<RccMr::C1>{
              {.key = "C1",
               .description = "primary creep strain at unit equivalent stress and time [1/(time^C2 stress^n1)]",
               .dimension = unit::none / unit::pow(unit::time, RccMr::C2) / unit::pow(unit::stress, RccMr::n1),
               .strict = false,
               .activation = Activation::rate}},
          Row<RccMr::C2>{{.key = "C2",
                          .description = "time exponent [-], not a function of T",
                          .dimension = unit::none,
                          .variables = {},
                          .maximum = 1.0}},
          Row<RccMr::n1>{stress_exponent("n1", "stress exponent of primary creep [-]")},
          Row<RccMr::C>{{.key = "C",
                         .description = "secondary rate at unit equivalent stress [1/(time stress^n)]",
                         .dimension = unit::per_time / unit::pow(unit::stress, RccMr::n),
                         .strict = false,
                         .activation = Activation::rate}},
          Row<RccMr::n>{stress_exponent("n", "stress exponent of secondary creep [-]")},
          Row<RccMr::C3>{{.key = "C3",
                          .description =
                              "end of primary creep at unit equivalent stress [time/stress^n3]; it ends earlier, and "
                              "with 0 only, when its rate has fallen to the secondary one",
                          .dimension = unit::time / unit::pow(unit::stress, RccMr::n3),
                          .strict = false,
                          .fallback = {{0.0}}}},
          Row<RccMr::n3>{{.key = "n3",
                          .description = "stress exponent of this time [-], usually negative",
                          .dimension = unit::none,
                          .minimum = any,
                          .strict = false,
                          .fallback = {{0.0}}}})),
      construct<RccMr>,
      {&hardening_strain}};
}

}  // namespace creepcontact::material
