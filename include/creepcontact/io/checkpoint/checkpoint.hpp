#pragma once
/// checkpoint.h5: everything needed to continue an interrupted run.

#include <filesystem>
#include <string>
#include <vector>

#include "creepcontact/base/memory.hpp"
#include "creepcontact/base/run_counters.hpp"

namespace creepcontact::io {

/// Content of a checkpoint.
struct Checkpoint {
  std::string fingerprint;  ///< of configuration and mesh; the caller compares it with its own
  std::string integrator;   ///< whose data is in `arrays`
  double time = 0;
  double next_step = 0;
  std::vector<double> state;  ///< y of the ODE
  RunCounters counters;       ///< of the run up to `time`
  Memory arrays;              ///< everything else that later steps depend on
};

/// Name under which the checkpoint before the one at `path` is kept: checkpoint.previous.h5.
std::filesystem::path previous_checkpoint(const std::filesystem::path& path);

/// Loads the library that write_checkpoint() needs, which takes as long as many steps; otherwise the first call does
/// it. What fails here is an error there. May run in any thread.
void prepare_checkpoints() noexcept;

/// Written as HDF5 next to the old file, synced to disk, then renamed over it, so that a complete checkpoint exists at
/// any moment. The old one is kept as previous_checkpoint(path). The user block of the file, which HDF5 tools skip,
/// contains a checksum (XXH3) of the HDF5 part.
/// @throws Error if the disk cannot take it; the old file is then still there
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// @throws ConfigError if the file is missing, truncated, damaged, not a checkpoint, or one that a version of the
/// program with another format of checkpoints has written
Checkpoint read_checkpoint(const std::filesystem::path& path);

/// @throws ConfigError if there is neither a checkpoint at `path` nor the previous one
void require_checkpoint(const std::filesystem::path& path);

/// Reads the checkpoint at `path`. If that fails, warns why and reads the previous one, which then replaces it.
/// @throws ConfigError with both reasons if neither can be read
Checkpoint read_last_checkpoint(const std::filesystem::path& path);

/// Removes both checkpoints, and unfinished ones next to them, so that a new run is not taken for a continuation of the
/// old one.
void remove_checkpoints(const std::filesystem::path& path);

}  // namespace creepcontact::io
