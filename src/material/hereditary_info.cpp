/// The names under which linear viscoelastic creep is known.

#include <fmt/format.h>

#include "hereditary.hpp"

namespace creepcontact::material {
namespace {

ParameterInfo compliance() {
  return {"compliance", "uniaxial compliance J of the Kelvin element [1/stress]", 0.0, false};
}
ParameterInfo retardation() {
  return {"time", "retardation time tau of the Kelvin element [time]", 0.0, true};
}
ParameterInfo viscosity() {
  return {"viscosity", "uniaxial viscosity of the dashpot in series: rate = q/viscosity [stress time]", 0.0, true};
}

Function inverse(const Function& viscosity) {
  return Function::composed(fmt::format("1/({})", viscosity.text()), {viscosity},
                            [](const std::vector<double>& values) { return 1.0 / values[0]; });
}

}  // namespace

LawInfo hereditary_info() {
  return {"hereditary",
          "strain at constant stress = sigma (sum of J_i (1 - exp(-t/tau_i)) + fluidity t)",
          "L. Boltzmann, 1874; V. Volterra, 1909; R. de Prony, 1795",
          {{.key = "compliances",
            .description = "uniaxial compliances J_i of the Kelvin elements [1/stress]",
            .strict = false,
            .list = true},
           {.key = "times", .description = "retardation times tau_i [time]", .list = true},
           {.key = "volumetric_compliances",
            .description = "volumetric compliances B_i, volumetric strain per mean stress [1/stress]; not given: the "
                           "volume does not creep",
            .strict = false,
            .list = true,
            .fallback = std::vector<Function>{}},
           {.key = "fluidity",
            .description = "uniaxial fluidity of a dashpot in series, rate per stress [1/(stress time)]",
            .strict = false,
            .fallback = {{0.0}}}},
          [](ParameterValues p) -> std::unique_ptr<CreepLaw> {
            return std::make_unique<Hereditary>("hereditary", p.at(0), p.at(1), p.at(2), p.at(3).at(0));
          },
          {&kelvin_strain}};
}

LawInfo kelvin_voigt_info() {
  return {"kelvin_voigt",
          "strain at constant stress = sigma J (1 - exp(-t/tau))",
          "W. Thomson (Lord Kelvin), 1865; W. Voigt, 1892",
          {compliance(), retardation()},
          [](ParameterValues p) -> std::unique_ptr<CreepLaw> {
            return std::make_unique<Hereditary>("kelvin_voigt", p.at(0), p.at(1), std::vector<Function>{}, 0.0);
          },
          {&kelvin_strain}};
}

LawInfo maxwell_info() {
  return {"maxwell",
          "rate = q/viscosity",
          "J. C. Maxwell, 1867",
          {viscosity()},
          [](ParameterValues p) -> std::unique_ptr<CreepLaw> {
            const std::vector<Function> none;
            return std::make_unique<Hereditary>("maxwell", none, none, none, inverse(p.at(0).at(0)));
          }};
}

LawInfo burgers_info() {
  return {"burgers",
          "strain at constant stress = sigma (J (1 - exp(-t/tau)) + t/viscosity)",
          "J. M. Burgers, 1935",
          {viscosity(), compliance(), retardation()},
          [](ParameterValues p) -> std::unique_ptr<CreepLaw> {
            return std::make_unique<Hereditary>("burgers", p.at(1), p.at(2), std::vector<Function>{},
                                                inverse(p.at(0).at(0)));
          },
          {&kelvin_strain}};
}

}  // namespace creepcontact::material
