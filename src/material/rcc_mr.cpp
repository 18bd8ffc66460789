#include "rcc_mr.hpp"

#include <limits>

#include "arrhenius.hpp"
#include "constant_parameter.hpp"
#include "power.hpp"

namespace creepcontact::material {

/// Both stages at one stress.
struct RccMr::Stages {
  Stages(double q, const PointState& at)
      : C2(at.parameters[1]),
        n1(at.parameters[2]),
        n(at.parameters[4]),
        primary(at.parameters[0] * power(q, n1)),
        secondary(at.parameters[3] * power(q, n)) {
    const double C3 = at.parameters[5], n3 = at.parameters[6];
    constexpr double never = std::numeric_limits<double>::infinity();
    if (C3 > 0.0)
      end = C3 * std::pow(q, n3);
    else if (secondary == 0.0 || (C2 == 1.0 && primary >= secondary))
      end = never;
    else if (C2 < 1.0)
      end = std::pow(C2 * primary / secondary, 1.0 / (1.0 - C2));  // both rates are equal
    if (primary > 0.0) end_strain = primary * std::pow(end, C2);
  }

  double rate(double eps) const {
    if (eps >= end_strain) return secondary;
    return C2 * primary * std::pow(primary / eps, 1.0 / C2 - 1.0);
  }
  /// Time after which virgin material has this strain in primary creep.
  double time(double eps) const { return std::pow(eps / primary, 1.0 / C2); }

  double C2, n1, n;
  double primary;    ///< strain after a unit of time
  double secondary;  ///< rate
  double end = 0, end_strain = 0;
};

RccMr::RccMr(Function C1, Function C2, Function n1, Function C, Function n, Function C3, Function n3)
    : HardeningLaw(
          {std::move(C1), std::move(C2), std::move(n1), std::move(C), std::move(n), std::move(C3), std::move(n3)},
          true) {
  require_constant("C2", parameters()[1], 0.0, 1.0);
}

double RccMr::equivalent_rate(double q, double eps, const PointState& at) const {
  return Stages(q, at).rate(eps);
}

HardeningRate RccMr::linearized_rate(double q, double eps, const PointState& at) const {
  const Stages stages(q, at);
  const double f = stages.rate(eps);
  if (eps >= stages.end_strain) return {f, f * stages.n / q, 0.0};
  return {f, f * stages.n1 / (stages.C2 * q), f * (1.0 - 1.0 / stages.C2) / eps};
}

double RccMr::accumulated(double q, double eps, const PointState& at, double duration) const {
  const Stages stages(q, at);
  if (eps >= stages.end_strain) return stages.secondary * duration;
  const double before = stages.time(eps);
  const double of_primary = std::min(duration, stages.end - before);
  const double grown = eps > 0.0 ? eps * std::expm1(stages.C2 * std::log1p(of_primary / before))
                                 : stages.primary * std::pow(of_primary, stages.C2);
  return grown + stages.secondary * (duration - of_primary);
}

double RccMr::start_exponent(const PointState& at) const {
  return at.parameters[0] > 0.0 ? at.parameters[1] : 1.0;
}

LawInfo rcc_mr_info() {
  const double any = -std::numeric_limits<double>::infinity();
  return {"rcc_mr",
          "strain at constant stress = C1 q^n1 t^C2 up to t_fp = C3 q^n3, then rate = C q^n",
          "AFCEN, RCC-MR, Appendix A3",
          with_arrhenius(
              {{"C1", "primary creep strain at unit equivalent stress and time [1/(time^C2 stress^n1)]", 0.0, false},
               {.key = "C2", .description = "time exponent [-], not a function of T", .variables = {}, .maximum = 1.0},
               {"n1", "stress exponent of primary creep [-]", 1.0, false},
               {"C", "secondary rate at unit equivalent stress [1/(time stress^n)]", 0.0, false},
               {"n", "stress exponent of secondary creep [-]", 1.0, false},
               {.key = "C3",
                .description = "end of primary creep at unit equivalent stress [time/stress^n3]; 0: when its rate has "
                               "fallen to the secondary one",
                .strict = false,
                .fallback = {{0.0}}},
               {.key = "n3",
                .description = "stress exponent of this time [-], usually negative",
                .minimum = any,
                .strict = false,
                .fallback = {{0.0}}}},
              "C1 and C"),
          [](ParameterValues p) -> std::unique_ptr<CreepLaw> {
            p = activated(std::move(p), {0, 3});
            return std::make_unique<RccMr>(p.at(0).at(0), p.at(1).at(0), p.at(2).at(0), p.at(3).at(0), p.at(4).at(0),
                                           p.at(5).at(0), p.at(6).at(0));
          },
          {&hardening_strain}};
}

}  // namespace creepcontact::material
