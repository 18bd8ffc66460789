#pragma once
/// The number of threads of a run.

#include <optional>

#include "creepcontact/platform/useful_threads.hpp"

namespace creepcontact::cli {

/// The threads of OpenMP.
class ThreadChoice {
 public:
  /// Sets them. @param wanted  0: as many as there are cores that other programs leave free
  explicit ThreadChoice(int wanted);
  /// Sets them again if none were asked for and the machine has become busier or idler, checked every ten seconds.
  /// @returns the new number if it has changed
  std::optional<int> update();

 private:
  std::optional<platform::ThreadWatch> watch_;
};

}  // namespace creepcontact::cli
