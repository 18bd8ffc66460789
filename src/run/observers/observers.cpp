#include "observers.hpp"

namespace creepcontact::run {

ObserverList make_observers(const RunContext& context, const std::vector<Observer*>& more) {
  ObserverList all(context.watch);
  for (MakeObserver* make :
       {observe_cycles, write_result_files, observe_step_statistics, observe_law_ranges, observe_preloads,
        observe_history_errors, observe_probes, observe_outcome, observe_friction_uniqueness,
        observe_equilibrium_residual, observe_heat, observe_contact_width, observe_life, observe_events,
        observe_criteria, observe_small_strains, observe_sensitivities})
    if (auto observer = make(context)) all.add(std::move(observer));
  for (Observer* observer : more) all.add(*observer);
  return all;
}

}  // namespace creepcontact::run
