#pragma once
/// How much smaller the error of a step must be if the integration starts again very often.

#include <string>

namespace creepcontact::ode {

/// Part of the tolerance for which steps are controlled, so that the error of a run stays what it is with few restarts.
/// Every piece of smooth loads leaves an error of the strain, most of them of one sign, which adds up where no stress
/// relaxes. Methods that begin again at order 1, and those of low order, leave most: measured with Norton's law under
/// a load that goes up and down 200 times. 1 for methods that begin at full order.
/// @param restarts  in the whole run
double restart_share(const std::string& integrator, double restarts);

/// Likewise for the rises and falls of loads that vibrate, through which steps go on without restarts. Not less than
/// 1e-3: beyond, the errors of steps bounded to a part of the period cancel.
double vibration_share(double turns);

}  // namespace creepcontact::ode
