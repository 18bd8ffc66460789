#pragma once
/// The runs of a study divided among independent processes: which runs each has, where it keeps them.

#include <filesystem>
#include <optional>
#include <vector>

#include "creepcontact/study/study.hpp"

namespace creepcontact::study {

/// Every count-th run, beginning with the shard's own number: costs that grow along an axis are shared evenly.
std::vector<std::size_t> runs_of_shard(std::size_t n_runs, const Shard& shard);
int shard_of_run(std::size_t run, int count);

/// DIR/shards/003, which only one process uses at a time.
std::filesystem::path shard_directory(const std::filesystem::path& study, int shard);
/// DIR/shards/003/runs.h5
std::filesystem::path shard_file(const std::filesystem::path& study, int shard);

/// Into how many shards the study in this directory is divided; nullopt: none was started.
std::optional<int> shard_count(const std::filesystem::path& study);

/// Says so for all shards to come; processes may do so at the same time.
/// @throws ConfigError if it is divided into another number of shards
void claim_shard_count(const std::filesystem::path& study, int count);

}  // namespace creepcontact::study
