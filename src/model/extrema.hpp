#pragma once
/// Where a function of time turns back: a step that reaches over such a point may miss a whole pulse of load.

#include <vector>

#include "creepcontact/base/function.hpp"

namespace creepcontact::model {

/// Times in (0, end) at which an expression in t has a maximum or minimum, by 2000 samples: each to within end/2000,
/// shorter pulses are not seen. Turns by less than 1 % of the whole change are none; more than 100 are a vibration,
/// which the integrator resolves without stops, and are left out. Tables know their points themselves: none.
std::vector<double> extrema(const Function& function, double end);
/// How far they may be from where the function turns.
double extremum_error(double end);

}  // namespace creepcontact::model
