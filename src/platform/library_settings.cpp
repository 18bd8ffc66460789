#include "creepcontact/platform/library_settings.hpp"

#include <unistd.h>

#include <cstdlib>

#include "creepcontact/platform/interrupt.hpp"

namespace creepcontact::platform {

void set_libraries(char** arguments) {
  const bool waiting_is_set = std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv("GOMP_SPINCOUNT") != nullptr;
  const bool blas_is_set = std::getenv("OPENBLAS_NUM_THREADS") != nullptr;
  const bool malloc_is_set = std::getenv("GLIBC_TUNABLES") != nullptr;
  if (waiting_is_set && blas_is_set && malloc_is_set) return;
  if (!waiting_is_set) setenv("OMP_WAIT_POLICY", "passive", 1);
  setenv("OPENBLAS_NUM_THREADS", "1", 0);
  setenv("GLIBC_TUNABLES", "glibc.malloc.hugetlb=1", 0);
  const BlockedSignals until_handled_again;
  execv("/proc/self/exe", arguments);  // returns only where that cannot be done: then the libraries do as they like
}

}  // namespace creepcontact::platform
