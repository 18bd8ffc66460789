#include "shard_store.hpp"

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/base/log.hpp"

namespace creepcontact::study {

ShardStore::ShardStore(const config::Study& study, const config::Vocabulary& vocabulary, std::filesystem::path file)
    : records_(study, vocabulary), file_(std::move(file)) {
  if (!path_exists(file_)) return;
  try {
    runs_ = read_shard_file(file_);
  } catch (const ConfigError& error) {
    log::warning("{}; the runs in it do not count", error.what());
  }
}

const KeptRun* ShardStore::find(std::size_t index, const config::PlannedRun& run) {
  const auto found = runs_.find(index);
  return found != runs_.end() && found->second.record == record_checksum(records_.of(run)) ? &found->second : nullptr;
}

void ShardStore::take(std::size_t index, const config::PlannedRun& run, const std::filesystem::path& directory) {
  RunOutcome outcome = found_outcome(directory);
  if (outcome.row.succeeded() || outcome.row.status == "failed")
    runs_[index] = {record_checksum(records_.of(run)), std::move(outcome)};
}

void remove_directory(const std::filesystem::path& directory) {
  std::error_code ignored;  // what is left is only in the way
  std::filesystem::remove_all(directory, ignored);
}

}  // namespace creepcontact::study
