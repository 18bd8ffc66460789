#pragma once
/// What [heat] should be looked at for before its results are believed.

#include "creepcontact/heat/figures.hpp"

namespace creepcontact::model {

/// Tells how long each body takes to heat through, and warns where that is long against the run: the unit of time is
/// the likeliest mistake. Warns of films whose fluid jumps while the element Biot number is above 1.
/// @param end  of the run @param starts_steady  with the fluids of the start
void tell_of_heat(const heat::Definition& definition, const heat::Figures& figures, double end, bool starts_steady,
                  const std::string& units);

}  // namespace creepcontact::model
