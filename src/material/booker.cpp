#include "booker.hpp"

#include <limits>

#include "arrhenius.hpp"
#include "hardening_law.hpp"

namespace creepcontact::material {
namespace {

StressFunction at_all_stresses(const Function& of) {
  return {of, 0.0, BelowRange::constant};
}

}  // namespace

Booker::Booker(const ParameterValues& values)
    : ScalarStateLaw({values[strength]}),
      curves_{{{at_all_stresses(values[limit_1].at(0)), at_all_stresses(values[speed_1].at(0)),
                at_all_stresses(values[rate_1].at(0))},
               {at_all_stresses(values[limit_2].at(0)), at_all_stresses(values[speed_2].at(0)),
                at_all_stresses(values[rate_2].at(0))}}},
      changes_(at_all_stresses(inverse(values[change].at(0)))),
      min_temperature_(values[min_temperature].empty() ? -std::numeric_limits<double>::infinity()
                                                       : values[min_temperature][0]({})) {}

bool Booker::evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const {
  if (&variable != &hardening_strain) return false;
  into[0] = at.internal[0];
  return true;
}

LawInfo booker_info() {
  using Law = Booker;
  const auto function = [](const char* key, const std::string& meaning, const UnitPowers& dimension) {
    return ParameterInfo{
        .key = key, .description = meaning, .dimension = dimension, .strict = false, .variables = {"q", "T", "U"}};
  };
  return {
      "booker",
      "strain at constant stress = the smaller of e_1(t), e_2(t) up to t = change, then e_2 from this strain on; e_i = "
      "limit_i speed_i t/(1 + speed_i t) + rate_i t",
      "M. K. Booker, ORNL; ASME III-5 HBB",
      law_table(
          Row<Law::strength>{{.key = "strength",
                              .description = "tensile strength, U in the expressions of the other keys [stress]",
                              .dimension = unit::stress}},
          Row<Law::limit_1>{
              function("limit_1",
                       "limit of the primary creep strain of the first curve, a function of the von Mises "
                       "stress q, temperature T and strength U [-]",
                       unit::none)},
          Row<Law::speed_1>{
              function("speed_1", "rate at which the first curve approaches this limit, a function of q, T, U [1/time]",
                       unit::per_time)},
          Row<Law::rate_1>{
              function("rate_1", "steady rate of the first curve, a function of q, T, U [1/time]", unit::per_time)},
          Row<Law::limit_2>{function("limit_2", "limit of the second curve, likewise [-]", unit::none)},
          Row<Law::speed_2>{function(
              "speed_2", "rate at which the second curve approaches its limit, likewise [1/time]", unit::per_time)},
          Row<Law::rate_2>{function("rate_2", "steady rate of the second curve, likewise [1/time]", unit::per_time)},
          Row<Law::change>{{.key = "change",
                            .description = "time of the change to the second curve, a function of q, T, U [time]",
                            .dimension = unit::time,
                            .variables = {"q", "T", "U"}}},
          Row<Law::min_temperature>{{.key = "min_temperature",
                                     .description = "there is no creep up to this temperature; not given: none",
                                     .dimension = unit::temperature,
                                     .minimum = -std::numeric_limits<double>::infinity(),
                                     .strict = false,
                                     .fallback = std::vector<Function>{},
                                     .variables = {}}}),
      construct<Law>,
      {&hardening_strain}};
}

}  // namespace creepcontact::material
