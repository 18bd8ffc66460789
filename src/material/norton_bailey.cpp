#include "norton_bailey.hpp"

#include "arrhenius.hpp"
#include "strain_hardening.hpp"
#include "time_hardening.hpp"

namespace creepcontact::material {
namespace {

enum NortonBaileyConstant {
  A = power_law::A,
  n = power_law::n,
  m = power_law::m,
  hardening = power_law::n_constants,
  n_constants
};

}  // namespace

LawInfo norton_bailey_info() {
  return {
      "norton_bailey",
      "strain at constant stress = A q^n t^m",
      "F. H. Norton, 1929; R. W. Bailey, 1935",
      with_arrhenius(law_table(
          Row<A>{power_law::factor()}, Row<n>{stress_exponent()},
          Row<m>{{.key = "m",
                  .description = "time exponent [-]; with strain hardening a number in (0, 1]",
                  .dimension = unit::none}},
          Row<hardening>{{.key = "hardening",
                          .description = "what the rate depends on where the stress changes: the creep strain that has "
                                         "accumulated, or the time of the run",
                          .dimension = unit::none,
                          .fallback = {{0.0}},
                          .words = {"strain", "time"}}})),
      [](const ParameterValues& values) -> std::unique_ptr<CreepLaw> {
        constexpr double time = 1;  // the second word
        if (values[hardening].at(0)({}) == time) return std::make_unique<TimeHardening>("norton_bailey", values);
        return std::make_unique<StrainHardening>("norton_bailey", values);
      },
      {&hardening_strain}};
}

}  // namespace creepcontact::material
