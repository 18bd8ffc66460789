#include "creepcontact/material/registry.hpp"

#include <algorithm>

#include "ageing.hpp"
#include "expression_law.hpp"
#include "garofalo.hpp"
#include "hereditary.hpp"
#include "kachanov_rabotnov.hpp"
#include "norton.hpp"
#include "strain_hardening.hpp"
#include "time_hardening.hpp"

namespace creepcontact::material {

const std::vector<LawInfo>& creep_laws() {
  static const std::vector<LawInfo> laws{
      norton_info(),             // secondary creep
      garofalo_info(),           //
      time_hardening_info(),     // primary creep
      graham_walles_info(),      //
      strain_hardening_info(),   //
      ageing_info(),             //
      kachanov_rabotnov_info(),  // tertiary creep
      hereditary_info(),         // viscoelastic creep
      kelvin_voigt_info(),       //
      maxwell_info(),            //
      burgers_info(),            //
      expression_info(),         // any other
  };
  return laws;
}

const std::vector<const StateVariable*>& state_variables() {
  static const std::vector<const StateVariable*> all = [] {
    std::vector<const StateVariable*> found{&damage, &life_fraction, &fatigue_fraction, &creep_fatigue};
    for (const LawInfo& law : creep_laws())
      for (const StateVariable* variable : law.state_variables)
        if (std::ranges::find(found, variable) == found.end()) found.push_back(variable);
    return found;
  }();
  return all;
}

const LawInfo* find_creep_law(const std::string& name) {
  const auto& laws = creep_laws();
  const auto found = std::find_if(laws.begin(), laws.end(), [&](const LawInfo& law) { return law.name == name; });
  return found == laws.end() ? nullptr : &*found;
}

}  // namespace creepcontact::material
