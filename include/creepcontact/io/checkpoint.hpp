#pragma once
/// checkpoint.h5: what a run needs to go on after an interruption.

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace creepcontact::io {

struct Checkpoint {
  std::string fingerprint;  ///< of the model (configuration and mesh); the reader's caller compares it with its own
  std::string integrator;   ///< whose memory is in `arrays`
  double time = 0;
  double next_step = 0;
  std::vector<double> state;                          ///< y of the ODE
  std::map<std::string, std::int64_t> counters;       ///< accumulated costs, output indices
  std::map<std::string, std::vector<double>> arrays;  ///< whatever else the run's continuation depends on
};

/// The name that the checkpoint before the one at `path` has: checkpoint.previous.h5.
std::filesystem::path previous_checkpoint(const std::filesystem::path& path);

/// HDF5, beside the old file, synced to disk, then renamed over it: at any moment one whole checkpoint exists. The old
/// one is kept as previous_checkpoint(path). A CRC-32 of the HDF5 part stands in the file's user block, which HDF5
/// tools skip.
/// @throws Error if the disk does not take it; the old file is then still there
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// @throws ConfigError if the file is missing, cut short, damaged or no checkpoint of this program
Checkpoint read_checkpoint(const std::filesystem::path& path);

/// The one at `path` or, with a warning that says why, the previous one, which then takes its place.
/// @throws ConfigError saying of both what is wrong, if neither can be read
Checkpoint read_last_checkpoint(const std::filesystem::path& path);

/// Removes both, and what was begun beside them: a new run must not be taken for a continuation of the old one.
void remove_checkpoints(const std::filesystem::path& path);

}  // namespace creepcontact::io
