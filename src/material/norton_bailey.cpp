#include "norton_bailey.hpp"

#include "arrhenius.hpp"
#include "strain_hardening.hpp"
#include "time_hardening.hpp"

namespace creepcontact::material {

LawInfo norton_bailey_info() {
  return {
      "norton_bailey",
      "strain at constant stress = A q^n t^m",
      "F. H. Norton, 1929; R. W. Bailey, 1935",
      with_arrhenius({{"A", "creep strain at unit equivalent stress and time [1/(time^m stress^n)]", 0.0, false},
                      {"n", "stress exponent [-]", 1.0, false},
                      {"m", "time exponent [-]; with strain hardening a number in (0, 1]", 0.0, true},
                      {.key = "hardening",
                       .description = "what the rate depends on where the stress changes: the creep strain that has "
                                      "accumulated, or the time of the run",
                       .fallback = {{0.0}},
                       .words = {"strain", "time"}}}),
      [](ParameterValues p) -> std::unique_ptr<CreepLaw> {
        p = activated(std::move(p), {0});
        constexpr double time = 1;  // the second word
        if (p.at(3).at(0)({}) == time)
          return std::make_unique<TimeHardening>("norton_bailey", p.at(0), p.at(1), p.at(2));
        return std::make_unique<StrainHardening>("norton_bailey", p.at(0).at(0), p.at(1).at(0), p.at(2).at(0));
      },
      {&hardening_strain}};
}

}  // namespace creepcontact::material
