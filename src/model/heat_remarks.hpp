#pragma once
/// What [heat] should be looked at for before its results are believed.

#include <span>

#include "creepcontact/config/config.hpp"
#include "creepcontact/heat/conduction.hpp"

namespace creepcontact::model {

/// Tells how long each body takes to heat through, and warns where that is long against the run: the unit of time is
/// the likeliest mistake. Warns of films whose fluid jumps while the element Biot number is above 1.
/// @param start  temperatures of all nodes at t = 0 @param end  of the run
void tell_of_heat(const config::Heat& heat, const heat::Conduction& problem, std::span<const double> start, double end);

}  // namespace creepcontact::model
