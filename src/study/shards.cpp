#include "shards.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "run_outcome.hpp"

namespace creepcontact::study {
namespace {

namespace fs = std::filesystem;

fs::path count_file(const fs::path& study) {
  return study / "shards" / "count.txt";
}

}  // namespace

std::vector<std::size_t> runs_of_shard(std::size_t n_runs, const Shard& shard) {
  std::vector<std::size_t> runs;
  for (std::size_t run = static_cast<std::size_t>(shard.number) - 1; run < n_runs;
       run += static_cast<std::size_t>(shard.count))
    runs.push_back(run);
  return runs;
}

int shard_of_run(std::size_t run, int count) {
  return static_cast<int>(run % static_cast<std::size_t>(count)) + 1;
}

fs::path shard_directory(const fs::path& study, int shard) {
  return study / "shards" / fmt::format("{:03}", shard);
}

fs::path shard_file(const fs::path& study, int shard) {
  return shard_directory(study, shard) / "runs.h5";
}

std::optional<int> shard_count(const fs::path& study) {
  const int count = std::atoi(file_text(count_file(study)).c_str());
  return count > 0 ? std::optional(count) : std::nullopt;
}

void claim_shard_count(const fs::path& study, int count) {
  platform::make_inner_directory(study / "shards");
  const fs::path file = count_file(study);
  fs::path own = file;
  own += fmt::format(".{}", unique_suffix());
  platform::replace_file(own, fmt::format("{}\n", count));
  // A link is made by one process alone, and never seen before its content.
  std::error_code failure, ignored;
  if (!path_exists(file)) fs::create_hard_link(own, file, failure);
  if (failure && !path_exists(file)) fs::rename(own, file, ignored);  // a file system without links
  fs::remove(own, ignored);
  const int found = shard_count(study).value_or(count);
  if (found == count) return;
  throw ConfigError(
      fmt::format("this study is divided into {0} shards: --shard i/{0}, and not /{1}; to divide it otherwise, choose "
                  "another directory with --output, or remove '{2}' (runs that have directories of their own are kept)",
                  found, count, (study / "shards").string()));
}

}  // namespace creepcontact::study
