#pragma once
/// Thermal activation of a rate: A_eff(T) = A(T) exp(-Q/(R (T - absolute_zero))). Source: S. Arrhenius (1889);
/// J. E. Dorn, J. Mech. Phys. Solids 3 (1955), for creep.

#include "creepcontact/material/registry.hpp"

namespace creepcontact::material {

/// Appends the optional keys activation_energy, gas_constant, absolute_zero.
/// @param of  the parameters that are activated, for the description
std::vector<ParameterInfo> with_arrhenius(std::vector<ParameterInfo> own, const std::string& of = "A");

/// Values whose last three belong to the keys of with_arrhenius(): the parameters with these numbers (all of a list)
/// are multiplied by exp(-Q/(R (T - absolute_zero))). They become functions of T that throw ModelError at or below
/// absolute zero. With Q = 0 they are as they were.
/// @param energy  number of the parameter Q; by default activation_energy
/// @throws std::out_of_range if there are too few values
ParameterValues activated(ParameterValues values, std::initializer_list<std::size_t> numbers,
                          std::optional<std::size_t> energy = {});

}  // namespace creepcontact::material
