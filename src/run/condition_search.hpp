#pragma once
/// When a condition begins to hold within a step.

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "observer_list.hpp"

namespace creepcontact::run {

/// A state of the step as a condition sees it.
struct ConditionState {
  bool holds = false;
  std::vector<double> values;  ///< Observer::values()
};
/// Gives that state at a time of the interval.
using ConditionAt = std::function<ConditionState(double)>;
/// Observer::would_hold()
using WouldHold = std::function<bool(double time, std::span<const double> values)>;

/// First time in (from, to] at which the condition holds, on the side where it holds. Guesses come from polynomials
/// through the values; where these do not serve, or without values, the interval is halved. If the condition changes
/// several times within the interval, one of the changes is found.
/// Precondition: it does not hold at `from`. @param at_end  the state at `to`, where it holds
/// @param resolution  relative to the interval @returns `to` if both are equal
/// Cost: some five states with values, else log2(1 / resolution)
double first_time(double from, double to, double resolution, ConditionState at_end, const ConditionAt& at,
                  const WouldHold& would_hold);

/// The exact state of the run at a time of the interval.
using ViewAt = std::function<StepView(double)>;

/// A state at the end of the interval within the tolerance, cheaper than the exact one.
using NearEnd = std::function<StepView()>;

/// Tells the observers what happens in (from, to], up to the first that stops the run. Collective.
/// @param from  equal to `to`: what holds at this time
/// @param near_end  if not empty: what does not hold in this state is not searched for. What holds exactly nevertheless
/// is found after a later step
/// @returns the time of that stop, if there is one
/// Cost: what the observers' conditions cost near the end, and for each that holds there as first_time()
std::optional<double> find_conditions(double from, double to, const ViewAt& view_at, const NearEnd& near_end,
                                      const ObserverList& observers);

}  // namespace creepcontact::run
