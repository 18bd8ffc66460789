#pragma once
/// Output variables of the unified viscoplastic laws.

#include "creepcontact/material/state_variable.hpp"

namespace creepcontact::material {

inline constexpr StateVariable isotropic_hardening{
    .name = "isotropic_hardening",
    .description = "growth R of the elastic range by isotropic hardening of `chaboche`; negative: softening",
    .label = "isotropic hardening R",
    .of_several = StateVariable::OfSeveralLaws::sum,
    .minimum = -std::numeric_limits<double>::infinity(),
    .dimension = Dimension::stress};
inline constexpr StateVariable accumulated_inelastic_strain{
    .name = "accumulated_inelastic_strain",
    .description = "length p of the path of the inelastic strain in `chaboche`, which grows with every cycle",
    .label = "accumulated strain p",
    .of_several = StateVariable::OfSeveralLaws::sum};
inline constexpr StateVariable drag_stress{.name = "drag_stress",
                                           .description = "deformation resistance s of `anand`",
                                           .label = "deformation resistance s",
                                           .dimension = Dimension::stress};

}  // namespace creepcontact::material
