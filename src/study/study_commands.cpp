#include <fmt/format.h>

#include <algorithm>

#include "creepcontact/base/log.hpp"
#include "shell_text.hpp"
#include "study_directory.hpp"

namespace creepcontact::study {
namespace {

namespace fs = std::filesystem;

/// "creepcontact study STUDY.toml --output DIR", good in every working directory.
std::string command_of(const config::Study& study, const StudyOptions& options) {
  return fmt::format("{} study {} --output {}{}", shell_quoted(options.program.string()),
                     shell_quoted(fs::absolute(study.file).string()),
                     shell_quoted(fs::absolute(directory_of(study, options)).string()),
                     options.trust_geometry ? " --trust-geometry" : "");
}

}  // namespace

std::string shell_quoted(const std::string& text) {
  const char* const plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=./,:@%";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char letter : text) quoted += letter == '\'' ? "'\\''" : std::string(1, letter);
  return quoted + "'";
}

std::vector<std::string> run_commands(const config::Study& study, const StudyOptions& options) {
  const std::string command = command_of(study, options);
  std::vector<std::string> commands;
  if (const auto reference = config::reference_run(study))
    commands.push_back(fmt::format("{} --run {}", command, reference->name));
  for (const config::PlannedRun& run : config::plan(study))
    commands.push_back(fmt::format("{} --run {}", command, run.name));
  return commands;
}

std::string slurm_script(const config::Study& study, const StudyOptions& options, int shards) {
  constexpr int usual = 100, usual_limit = 1000;
  shards = std::min(shards == 0 ? usual : shards, static_cast<int>(config::plan(study).size()));
  if (shards > usual_limit)
    log::warning("{} shards: most installations of Slurm take arrays of up to {} jobs (MaxArraySize); --shards {} does",
                 shards, usual_limit, usual_limit);
  const std::string command = command_of(study, options);
  const std::string name = shell_quoted(study.file.stem().string());
  return fmt::format(R"(#!/bin/sh
# Submits the study as an array of {0} jobs, and after them one that gathers. Ask for time, memory and partition by
# options of sbatch: they go to all of them, but --array=... to the array alone.
set -eu
array=$(sbatch --parsable --job-name={1} --array=1-{0} "$@" <<'END_OF_JOB'
#!/bin/sh
exec {2} --shard "$SLURM_ARRAY_TASK_ID/{0}" --jobs "${{SLURM_CPUS_PER_TASK:-1}}"
END_OF_JOB
)
echo "shards: job ${{array%%;*}}"
for option in "$@"; do
  shift
  case $option in --array=*) ;; *) set -- "$@" "$option" ;; esac
done
# afterany: what the shards have made is gathered even if one of them was killed.
gathering=$(sbatch --parsable --job-name={1}-gather --dependency="afterany:${{array%%;*}}" "$@" <<'END_OF_JOB'
#!/bin/sh
exec {2} --gather
END_OF_JOB
)
echo "gathering: job ${{gathering%%;*}}"
)",
                     shards, name, command);
}

}  // namespace creepcontact::study
