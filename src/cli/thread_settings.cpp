#include "thread_settings.hpp"

#include <omp.h>
#include <unistd.h>

#include <cstdlib>

#include "creepcontact/platform/interrupt.hpp"
#include "creepcontact/platform/useful_threads.hpp"
#include "creepcontact/run/threads.hpp"

namespace creepcontact::cli {

void set_threads(char** arguments) {
  const bool waiting_is_set = std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv("GOMP_SPINCOUNT") != nullptr;
  const bool blas_is_set = std::getenv("OPENBLAS_NUM_THREADS") != nullptr;
  if (waiting_is_set && blas_is_set) return;
  if (!waiting_is_set) setenv("OMP_WAIT_POLICY", "passive", 1);
  setenv("OPENBLAS_NUM_THREADS", "1", 0);
  const platform::BlockedSignals until_handled_again;
  execv("/proc/self/exe", arguments);  // returns only where that cannot be done: then the libraries do as they like
}

void use_threads(int wanted) {
  omp_set_num_threads(run::affordable_threads(wanted > 0 ? wanted : omp_get_max_threads()));
  if (wanted == 0) omp_set_num_threads(platform::useful_threads());
}

}  // namespace creepcontact::cli
