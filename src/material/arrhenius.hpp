#pragma once
/// Thermal activation of a rate: A_eff(T) = A(T) exp(-Q/(R (T - absolute_zero))). Source: S. Arrhenius (1889);
/// J. E. Dorn, J. Mech. Phys. Solids 3 (1955), for creep.

#include "creepcontact/material/registry.hpp"

namespace creepcontact::material {

/// Optional keys activation_energy, gas_constant, absolute_zero, in the order of arrhenius().
std::vector<ParameterInfo> with_arrhenius(std::vector<ParameterInfo> own);

/// @param Q  energy a mole, >= 0; zero: A as it is
/// @param R  energy a mole and degree
/// @param absolute_zero  the temperature of absolute zero in the user's unit
/// @returns a function of T that throws ModelError at or below absolute zero
Function arrhenius(Function A, const Function& Q, const Function& R, const Function& absolute_zero);

}  // namespace creepcontact::material
