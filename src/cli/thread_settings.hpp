#pragma once
/// Settings of threads and memory that the libraries read before main, and the number of threads.

#include <optional>

#include "creepcontact/platform/useful_threads.hpp"

namespace creepcontact::cli {

/// Sets, unless the user has, that waiting threads of OpenMP sleep (spinning ones take the cores from other programs),
/// and that the BLAS makes no threads before it factors (each reserves 128 MB of address space). The libraries read
/// that as they are loaded, so the program starts anew where it must be changed. glibc is told to ask for huge pages:
/// factors of a million pages of 4 kB cost more time to allocate than to read several times.
/// @param arguments  of main
void set_libraries(char** arguments);

/// The threads of OpenMP.
class ThreadChoice {
 public:
  /// Sets them. @param wanted  0: as many as there are cores that other programs leave free
  explicit ThreadChoice(int wanted);
  /// Sets them anew if none were asked for and the machine has become busier or idler, seen every ten seconds.
  /// @returns the new number if it has changed
  std::optional<int> look();

 private:
  std::optional<platform::ThreadWatch> watch_;
};

}  // namespace creepcontact::cli
