/// The names under which linear viscoelastic creep is known.

#include <fmt/format.h>

#include "arrhenius.hpp"
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

Function inverse(const Function& of) {
  return Function::composed(fmt::format("1/({})", of.text()), {of},
                            [](const std::vector<double>& values) { return 1.0 / values[0]; });
}

/// Of parameters whose inverse is a rate: viscosities and times.
ParameterValues activated_inverse(ParameterValues values, std::size_t number) {
  if (values.at(values.size() - 3).at(0).is_zero()) return values;
  for (Function& value : values.at(number)) value = inverse(value);
  values = activated(std::move(values), {number});
  for (Function& value : values.at(number)) value = inverse(value);
  return values;
}

}  // namespace

LawInfo hereditary_info() {
  return {
      "hereditary",
      "strain at constant stress = sigma (sum of J_i (1 - exp(-t/tau_i)) + fluidity t)",
      "L. Boltzmann, 1874; V. Volterra, 1909; R. de Prony, 1795",
      with_arrhenius(
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
          "all rates: `fluidity` and 1/`times`"),
      [](ParameterValues p) -> std::unique_ptr<CreepLaw> {
        p = activated_inverse(activated(std::move(p), {3}), 1);
        return std::make_unique<Hereditary>("hereditary", p.at(0), p.at(1), p.at(2), p.at(3).at(0));
      },
      {&kelvin_strain}};
}

LawInfo kelvin_voigt_info() {
  return {"kelvin_voigt",
          "strain at constant stress = sigma J (1 - exp(-t/tau))",
          "W. Thomson (Lord Kelvin), 1865; W. Voigt, 1892",
          with_arrhenius({compliance(), retardation()}, "1/`time`"),
          [](ParameterValues p) -> std::unique_ptr<CreepLaw> {
            p = activated_inverse(std::move(p), 1);
            return std::make_unique<Hereditary>("kelvin_voigt", p.at(0), p.at(1), std::vector<Function>{}, 0.0);
          },
          {&kelvin_strain}};
}

LawInfo maxwell_info() {
  return {"maxwell", "rate = q/viscosity", "J. C. Maxwell, 1867", with_arrhenius({viscosity()}, "1/`viscosity`"),
          [](ParameterValues p) -> std::unique_ptr<CreepLaw> {
            p = activated_inverse(std::move(p), 0);
            const std::vector<Function> none;
            return std::make_unique<Hereditary>("maxwell", none, none, none, inverse(p.at(0).at(0)));
          }};
}

LawInfo burgers_info() {
  return {"burgers",
          "strain at constant stress = sigma (J (1 - exp(-t/tau)) + t/viscosity)",
          "J. M. Burgers, 1935",
          with_arrhenius({viscosity(), compliance(), retardation()}, "1/`viscosity` and 1/`time`"),
          [](ParameterValues p) -> std::unique_ptr<CreepLaw> {
            p = activated_inverse(activated_inverse(std::move(p), 0), 2);
            return std::make_unique<Hereditary>("burgers", p.at(1), p.at(2), std::vector<Function>{},
                                                inverse(p.at(0).at(0)));
          },
          {&kelvin_strain}};
}

}  // namespace creepcontact::material
