#pragma once
/// The observers of every run, one file each. A new one is a file and a line in each of the two lists.

#include <memory>

#include "../observer_list.hpp"
#include "../run_context.hpp"

namespace creepcontact::run {

/// Makes an observer; null if the run has nothing for it. @param context  must outlive the observer
using MakeObserver = std::unique_ptr<Observer>(const RunContext& context);

MakeObserver observe_cycles, write_result_files, observe_step_statistics, observe_law_ranges, observe_preloads,
    observe_history_errors, observe_probes, observe_outcome, observe_friction_uniqueness, observe_equilibrium_residual,
    observe_heat, observe_contact_width, observe_life, observe_events, observe_criteria, observe_small_strains,
    observe_sensitivities;

/// All of them, in the order in which they are asked. Cycles come first: others count what a cycle that is closed has
/// made final. @param more  of the caller, after the statistics of the steps; they must outlive the list
/// @throws ConfigError if a file cannot be opened
ObserverList make_observers(const RunContext& context, const std::vector<Observer*>& more);

}  // namespace creepcontact::run
