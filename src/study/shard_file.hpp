#pragma once
/// The finished runs of a shard in one HDF5 file, instead of a directory per run.

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "run_outcome.hpp"

namespace creepcontact::study {

/// A run and the checksum of its record (run_records.hpp), by which another study's or another version's is noticed.
struct KeptRun {
  std::uint64_t record = 0;
  RunOutcome outcome;
};

std::uint64_t record_checksum(const std::string& record);

/// Keys are indices of runs in the plan.
using ShardRuns = std::map<std::size_t, KeptRun>;

/// Replaces the file at once. Cost: some microseconds per run. @throws Error if the disk cannot take it
void write_shard_file(const std::filesystem::path& file, const ShardRuns& runs);

/// @throws ConfigError if the file cannot be read, or is damaged
ShardRuns read_shard_file(const std::filesystem::path& file);

}  // namespace creepcontact::study
