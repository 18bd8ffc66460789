#pragma once
/// How much memory this process may still take.

#include <filesystem>
#include <limits>
#include <string>

namespace creepcontact::platform {

/// What a user is told where memory runs out unforeseen.
inline constexpr const char* out_of_memory =
    "out of memory; a coarser mesh needs less: creepcontact check CONFIG.toml estimates how much";

struct Room {
  double bytes = std::numeric_limits<double>::infinity();
  std::string reason = {};  ///< what bounds it, in words
};

/// What limits of the process leave of its address space (ulimit -v, ulimit -d). There, memory counts that is only
/// reserved, too: stacks of threads, buffers of libraries.
Room address_space();
/// What the machine has left, and the control groups of the process (containers, batch systems) of it.
/// @param root  below which /proc and /sys are
Room free_memory(const std::filesystem::path& root = "/");

/// Largest resident memory of the process so far, bytes.
double peak_memory();

/// Number in MB or GB, for messages.
std::string memory_text(double bytes);

}  // namespace creepcontact::platform
