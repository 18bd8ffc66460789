#include "creepcontact/material/registry.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ageing.hpp"
#include "anand.hpp"
#include "arrhenius.hpp"
#include "blackburn.hpp"
#include "booker.hpp"
#include "chaboche.hpp"
#include "expression_law.hpp"
#include "garofalo.hpp"
#include "hayhurst.hpp"
#include "hereditary.hpp"
#include "kachanov_rabotnov.hpp"
#include "kocks_mecking.hpp"
#include "lemaitre.hpp"
#include "norton.hpp"
#include "norton_bailey.hpp"
#include "omega.hpp"
#include "rate_table.hpp"
#include "rcc_mr.hpp"
#include "soderberg.hpp"
#include "strain_hardening.hpp"
#include "theta_projection.hpp"
#include "time_hardening.hpp"

namespace creepcontact::material {

const std::vector<LawInfo>& creep_laws() {
  static const std::vector<LawInfo> laws{
      norton_info(),             // secondary creep
      garofalo_info(),           //
      kocks_mecking_info(),      //
      rate_table_info(),         //
      norton_bailey_info(),      // primary creep
      time_hardening_info(),     //
      graham_walles_info(),      //
      strain_hardening_info(),   //
      lemaitre_info(),           //
      ageing_info(),             //
      soderberg_info(),          // primary and secondary creep
      rcc_mr_info(),             //
      blackburn_info(),          //
      booker_info(),             //
      kachanov_rabotnov_info(),  // tertiary creep
      omega_info(),              //
      theta_projection_info(),   // all three stages
      hayhurst_info(),           //
      chaboche_info(),           // creep and plasticity
      anand_info(),              //
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
    std::vector<const StateVariable*> found{
        &damage,         &life_fraction,  &fatigue_fraction,          &creep_fatigue,
        &remaining_life, &plastic_strain, &plastic_strain_equivalent, &yield_stress,
        &back_stress};
    for (const LawInfo& law : creep_laws())
      for (const StateVariable* variable : law.state_variables)
        if (std::ranges::find(found, variable) == found.end()) found.push_back(variable);
    return found;
  }();
  return all;
}

std::unique_ptr<CreepLaw> LawInfo::make(ParameterValues values) const {
  if (values.size() != parameters.size())
    throw std::out_of_range(
        fmt::format("creep law '{}': {} values for {} parameters", name, values.size(), parameters.size()));
  return construct(activated(std::move(values), parameters));
}

std::unique_ptr<CreepLaw> LawInfo::make_by_key(const std::map<std::string, std::vector<Function>>& given) const {
  for (const auto& [key, values] : given)
    if (std::ranges::find(parameters, key, &ParameterInfo::key) == parameters.end())
      throw ParameterError(key, "a key that the law has not", fmt::format("the keys of '{}'", name));
  ParameterValues values;
  for (const ParameterInfo& parameter : parameters) {
    const auto found = given.find(parameter.key);
    if (found == given.end() && !parameter.fallback) throw ParameterError(parameter.key, "nothing", "a value");
    values.push_back(found != given.end() ? found->second : *parameter.fallback);
  }
  return make(std::move(values));
}

bool LawInfo::is_activation_energy(std::size_t parameter) const {
  return std::ranges::find(parameters, std::optional(parameter), &ParameterInfo::energy) != parameters.end();
}

const LawInfo* find_creep_law(const std::string& name) {
  const auto& laws = creep_laws();
  const auto found = std::find_if(laws.begin(), laws.end(), [&](const LawInfo& law) { return law.name == name; });
  return found == laws.end() ? nullptr : &*found;
}

}  // namespace creepcontact::material
