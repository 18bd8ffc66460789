#pragma once
/// The file of a shard, and which of its runs belong to the study as it is.

#include "run_records.hpp"
#include "shard_file.hpp"

namespace creepcontact::study {

class ShardStore {
 public:
  /// Reads the file, if it exists; one that cannot be read gives a warning, and its runs are made again.
  ShardStore(const config::Study& study, const config::Vocabulary& vocabulary, std::filesystem::path file);

  /// nullptr: not there, or made with other settings, files or another version.
  const KeptRun* find(std::size_t index, const config::PlannedRun& run);
  /// Takes what a run has left in its directory.
  void take(std::size_t index, const config::PlannedRun& run, const std::filesystem::path& directory);
  void write() const { write_shard_file(file_, runs_); }

 private:
  RunRecords records_;
  std::filesystem::path file_;
  ShardRuns runs_;
};

/// Removes the directory of a run, in that of the study.
void remove_directory(const std::filesystem::path& directory);

}  // namespace creepcontact::study
