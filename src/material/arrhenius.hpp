#pragma once
/// Thermal activation of a rate: A_eff(T) = A(T) exp(-Q/(R (T - absolute_zero))). Source: S. Arrhenius (1889);
/// J. E. Dorn, J. Mech. Phys. Solids 3 (1955), for creep.

#include "creepcontact/material/registry.hpp"

namespace creepcontact::material {

/// Constants that follow those of a law.
enum ArrheniusConstant { activation_energy, gas_constant, absolute_zero, n_arrhenius_constants };

/// Appends the rows of ArrheniusConstant to the table of a law, and gives its activated constants without an energy of
/// their own the activation energy.
std::vector<ParameterInfo> with_arrhenius(std::vector<ParameterInfo> own);

/// The row of the key `absolute_zero`, a number.
ParameterInfo absolute_zero_key();

/// T - absolute_zero. @throws ModelError if it is not positive
double absolute_temperature(double T, double absolute_zero);

/// The factor exp(-Q/(R (T - absolute_zero))), a function of T that throws ModelError at or below absolute zero; 1 if
/// Q = 0. @param values  of a table that with_arrhenius() made @param n_constants  of the law's own
Function activation_factor(const ParameterValues& values, std::size_t n_constants);

/// The values with the activation that the table gives them. With Q = 0 they are as they were.
ParameterValues activated(ParameterValues values, const std::vector<ParameterInfo>& table);

/// 1/(the function)
Function inverse(const Function& of);

}  // namespace creepcontact::material
