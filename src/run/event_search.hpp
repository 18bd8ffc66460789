#pragma once
/// When events happen within a step.

#include <functional>
#include <optional>
#include <span>

#include "creepcontact/results/event_watch.hpp"
#include "creepcontact/run/run.hpp"
#include "whole_state.hpp"

namespace creepcontact::run {

/// First time in (from, to] at which the condition holds, found by halving to 1e-10 of the interval, on the side where
/// it holds. Of several changes within the interval one is found.
/// Precondition: it does not hold at `from` and holds at `to`. Cost: at most 34 evaluations
double first_time(double from, double to, const std::function<bool(double)>& holds);

/// The state of the bodies at a time.
using StateAt = std::function<std::span<const double>(double)>;

/// Records the events that happen in (from, to], up to the first that stops the run. Collective.
/// @param from  equal to `to`: those that hold at this time
/// @param observer  told before messages; may be null
/// @returns the time of that stop, if there is one
/// Cost: an equilibrium at `to`, and at most 34 per event that happens; none if no event is left to happen
std::optional<double> find_events(double from, double to, const StateAt& state_at, WholeState& whole,
                                  results::EventWatch& events, RunObserver* observer);

}  // namespace creepcontact::run
