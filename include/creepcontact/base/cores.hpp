#pragma once
/// Processor cores of the machine.

#include <algorithm>
#include <thread>

namespace creepcontact {

/// Number of logical processors, at least 1.
inline int cores() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace creepcontact
