/// The names under which linear viscoelastic creep is known.

#include "arrhenius.hpp"
#include "hereditary.hpp"

namespace creepcontact::material {
namespace {

ParameterInfo compliance() {
  return {.key = "compliance",
          .description = "uniaxial compliance J of the Kelvin element [1/stress]",
          .dimension = unit::per_stress,
          .strict = false};
}
ParameterInfo retardation() {
  return {.key = "time",
          .description = "retardation time tau of the Kelvin element [time]",
          .dimension = unit::time,
          .activation = Activation::time};
}
ParameterInfo viscosity() {
  return {.key = "viscosity",
          .description = "uniaxial viscosity of the dashpot in series: rate = q/viscosity [stress time]",
          .dimension = unit::stress * unit::time,
          .activation = Activation::time};
}

}  // namespace

LawInfo hereditary_info() {
  using Law = Hereditary;
  return {"hereditary",
          "strain at constant stress = sigma (sum of J_i (1 - exp(-t/tau_i)) + fluidity t)",
          "L. Boltzmann, 1874; V. Volterra, 1909; R. de Prony, 1795",
          with_arrhenius(law_table(
              Row<Law::compliances>{{.key = "compliances",
                                     .description = "uniaxial compliances J_i of the Kelvin elements [1/stress]",
                                     .dimension = unit::per_stress,
                                     .strict = false,
                                     .list = true}},
              Row<Law::times>{{.key = "times",
                               .description = "retardation times tau_i [time]",
                               .dimension = unit::time,
                               .list = true,
                               .activation = Activation::time}},
              Row<Law::volumetric_compliances>{
                  {.key = "volumetric_compliances",
                   .description =
                       "volumetric compliances B_i, volumetric strain per mean stress [1/stress]; not given: the "
                       "volume does not creep",
                   .dimension = unit::per_stress,
                   .strict = false,
                   .list = true,
                   .fallback = std::vector<Function>{}}},
              Row<Law::fluidity>{
                  {.key = "fluidity",
                   .description = "uniaxial fluidity of a dashpot in series, rate per stress [1/(stress time)]",
                   .dimension = unit::per_stress / unit::time,
                   .strict = false,
                   .fallback = {{0.0}},
                   .activation = Activation::rate}})),
          [](const ParameterValues& values) -> std::unique_ptr<CreepLaw> {
            return std::make_unique<Hereditary>("hereditary", values);
          },
          {&kelvin_strain}};
}

LawInfo kelvin_voigt_info() {
  enum KelvinVoigtConstant { J, tau, n_constants };
  return {"kelvin_voigt",
          "strain at constant stress = sigma J (1 - exp(-t/tau))",
          "W. Thomson (Lord Kelvin), 1865; W. Voigt, 1892",
          with_arrhenius(law_table(Row<J>{compliance()}, Row<tau>{retardation()})),
          [](const ParameterValues& values) -> std::unique_ptr<CreepLaw> {
            ParameterValues chain(Hereditary::n_constants);
            chain[Hereditary::compliances] = values[J];
            chain[Hereditary::times] = values[tau];
            return std::make_unique<Hereditary>("kelvin_voigt", chain);
          },
          {&kelvin_strain}};
}

LawInfo maxwell_info() {
  enum MaxwellConstant { eta, n_constants };
  return {"maxwell", "rate = q/viscosity", "J. C. Maxwell, 1867", with_arrhenius(law_table(Row<eta>{viscosity()})),
          [](const ParameterValues& values) -> std::unique_ptr<CreepLaw> {
            ParameterValues dashpot(Hereditary::n_constants);
            dashpot[Hereditary::fluidity] = {inverse(values[eta].at(0))};
            return std::make_unique<Hereditary>("maxwell", dashpot);
          }};
}

LawInfo burgers_info() {
  enum BurgersConstant { eta, J, tau, n_constants };
  return {"burgers",
          "strain at constant stress = sigma (J (1 - exp(-t/tau)) + t/viscosity)",
          "J. M. Burgers, 1935",
          with_arrhenius(law_table(Row<eta>{viscosity()}, Row<J>{compliance()}, Row<tau>{retardation()})),
          [](const ParameterValues& values) -> std::unique_ptr<CreepLaw> {
            ParameterValues chain(Hereditary::n_constants);
            chain[Hereditary::compliances] = values[J];
            chain[Hereditary::times] = values[tau];
            chain[Hereditary::fluidity] = {inverse(values[eta].at(0))};
            return std::make_unique<Hereditary>("burgers", chain);
          },
          {&kelvin_strain}};
}

}  // namespace creepcontact::material
