#pragma once
/// How much more memory this process can use.

#include <filesystem>
#include <limits>
#include <string>

namespace creepcontact::platform {

/// Message for the user if memory runs out unexpectedly.
inline constexpr const char* out_of_memory =
    "out of memory; a coarser mesh needs less: creepcontact check CONFIG.toml estimates how much";

/// An amount of memory, and what limits it.
struct Room {
  double bytes = std::numeric_limits<double>::infinity();
  std::string reason = {};  ///< what limits it, in words
};

/// Address space left by the limits of the process (ulimit -v, ulimit -d). Memory that is only reserved counts as used:
/// stacks of threads, buffers of libraries.
Room address_space();
/// Memory left on the machine and in the control groups of the process (containers, batch systems).
/// @param root  directory that contains proc and sys
Room free_memory(const std::filesystem::path& root = "/");

/// Largest resident memory of the process so far [bytes].
double peak_memory();

/// For messages: the number in MB or GB, with the unit.
std::string memory_text(double bytes);

/// From here on the memory of blocks above a megabyte goes back to the system as soon as they are freed. By default the
/// C library keeps it for later, and what lies between blocks in use is lost to a program that needs each block once.
void return_large_blocks();

}  // namespace creepcontact::platform
