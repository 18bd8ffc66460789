#include "thread_settings.hpp"

#include <omp.h>
#include <unistd.h>

#include <cstdlib>

#include "creepcontact/platform/interrupt.hpp"
#include "creepcontact/run/threads.hpp"

namespace creepcontact::cli {

void set_libraries(char** arguments) {
  const bool waiting_is_set = std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv("GOMP_SPINCOUNT") != nullptr;
  const bool blas_is_set = std::getenv("OPENBLAS_NUM_THREADS") != nullptr;
  const bool malloc_is_set = std::getenv("GLIBC_TUNABLES") != nullptr;
  if (waiting_is_set && blas_is_set && malloc_is_set) return;
  if (!waiting_is_set) setenv("OMP_WAIT_POLICY", "passive", 1);
  setenv("OPENBLAS_NUM_THREADS", "1", 0);
  setenv("GLIBC_TUNABLES", "glibc.malloc.hugetlb=1", 0);
  const platform::BlockedSignals until_handled_again;
  execv("/proc/self/exe", arguments);  // returns only where that cannot be done: then the libraries do as they like
}

ThreadChoice::ThreadChoice(int wanted) {
  const int most = run::affordable_threads(wanted > 0 ? wanted : omp_get_max_threads());
  if (wanted == 0) watch_.emplace(most);
  omp_set_num_threads(watch_ ? watch_->threads() : most);
}

std::optional<int> ThreadChoice::look() {
  const std::optional<int> changed = watch_ ? watch_->look() : std::nullopt;
  if (changed) omp_set_num_threads(*changed);
  return changed;
}

}  // namespace creepcontact::cli
