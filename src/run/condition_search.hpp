#pragma once
/// When a condition begins to hold within a step.

#include <functional>
#include <optional>

#include "observer_list.hpp"

namespace creepcontact::run {

/// First time in (from, to] at which the condition holds, found by halving, on the side where it holds. If it
/// changes several times within the interval, one of the changes is found.
/// Precondition: it does not hold at `from` and holds at `to`.
/// @param resolution  relative to the interval @returns `to` if both are equal
/// Cost: log2(1 / resolution) evaluations
double first_time(double from, double to, double resolution, const std::function<bool(double)>& holds);

/// The run at a time of the interval.
using ViewAt = std::function<StepView(double)>;

/// Tells the observers what happens in (from, to], up to the first that stops the run. Collective.
/// @param from  equal to `to`: what holds at this time @returns the time of that stop, if there is one
/// Cost: what the observers' conditions cost at `to`, and for each that holds there as first_time()
std::optional<double> find_conditions(double from, double to, const ViewAt& view_at, const ObserverList& observers);

}  // namespace creepcontact::run
