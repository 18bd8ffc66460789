#pragma once
/// Processor cores.

#include <sched.h>

#include <algorithm>
#include <thread>

namespace creepcontact {

/// Number of logical processors that the process may use, as taskset or a batch system sets it; at least 1.
inline int cores() {
  cpu_set_t allowed;
  if (::sched_getaffinity(0, sizeof allowed, &allowed) == 0) return std::max(1, CPU_COUNT(&allowed));
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));  // more of them than a cpu_set_t has
}

}  // namespace creepcontact
