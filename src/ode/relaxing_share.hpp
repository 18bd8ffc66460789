#pragma once
/// Whether creep changes the stress.

#include <optional>
#include <span>

#include "creepcontact/ode/system.hpp"

namespace creepcontact::ode {

/// The change of the rate that the creep itself causes, relative to the one it would cause if no point could deform:
/// 0 where loads maintain a uniform stress, 1 between rigid grips. What makes creep faster, as damage does, counts as
/// no relaxation: 0 if it outweighs what the grips would do. None if nothing creeps, or without JacobianProducts.
/// Collective. Cost: a rate evaluation at (t, y) and a Jacobian product.
/// @param stable_step  of the system at (t, y)
std::optional<double> relaxing_share(System& system, double t, std::span<const double> y, double stable_step);

}  // namespace creepcontact::ode
