#include "thread_waiting.hpp"

#include <unistd.h>

#include <cstdlib>

namespace creepcontact::cli {

void let_waiting_threads_sleep(char** arguments) {
  if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv("GOMP_SPINCOUNT") != nullptr) return;
  setenv("OMP_WAIT_POLICY", "passive", 1);
  execv("/proc/self/exe", arguments);  // returns only where that cannot be done: then threads spin
}

}  // namespace creepcontact::cli
