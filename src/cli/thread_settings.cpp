#include "thread_settings.hpp"

#include <omp.h>

#include "creepcontact/cli/processes.hpp"
#include "creepcontact/run/threads.hpp"

namespace creepcontact::cli {

ThreadChoice::ThreadChoice(int wanted) {
  const int own = Processes::threads(omp_get_max_threads());
  const int most = run::affordable_threads(wanted > 0 ? wanted : own);
  // Where other processes of the program use the cores too, measuring would see them.
  if (wanted == 0 && own == omp_get_max_threads()) watch_.emplace(most);
  omp_set_num_threads(watch_ ? watch_->threads() : most);
}

std::optional<int> ThreadChoice::update() {
  const std::optional<int> changed = watch_ ? watch_->update() : std::nullopt;
  if (changed) omp_set_num_threads(*changed);
  return changed;
}

}  // namespace creepcontact::cli
