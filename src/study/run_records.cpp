#include "run_records.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "creepcontact/base/checksum.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/config/reader.hpp"
#include "creepcontact/io/temperatures/temperature_reader.hpp"
#include "run_outcome.hpp"

namespace creepcontact::study {
namespace {

namespace fs = std::filesystem;

std::string checksum_line(const fs::path& file) {
  const std::string text = file_text(file);
  Checksum checksum;
  checksum.add(text.data(), text.size());
  return fmt::format("{} {:016x}\n", file.filename().string(), checksum.value());
}

/// The lines of the files of temperatures.
std::string checksum_lines(const std::vector<fs::path>& files) {
  std::string lines;
  try {
    for (const fs::path& file : io::temperature_files({files})) lines += checksum_line(file);
  } catch (const ModelError&) {  // a pattern without files: the run tells
  }
  return lines;
}

bool names_files(const std::string& override_text) {
  return override_text.starts_with("mesh") || override_text.starts_with("temperature");
}

}  // namespace

const std::string& RunRecords::files_of(const std::vector<std::string>& overrides) {
  std::string key;
  for (const std::string& one : overrides)
    if (names_files(one)) key += one + '\n';
  const auto [found, is_new] = files_.try_emplace(key);
  if (!is_new) return found->second;
  const config::Config config = config::read(study_.base, vocabulary_, overrides);
  std::string lines = fmt::format("creepcontact {}\n", CREEPCONTACT_VERSION);
  lines += checksum_line(study_.base) + checksum_line(config.mesh.file);
  if (config.temperature && !config.temperature->files.empty()) lines += checksum_lines(config.temperature->files);
  return found->second = lines;
}

std::string RunRecords::of(const config::PlannedRun& run) {
  const std::vector<std::string> overrides = config::overrides(study_, run);
  std::string record;
  try {
    record = files_of(overrides);
  } catch (const ConfigError&) {
    files_.clear();  // a sample that the configuration cannot have: its run says why
  }
  for (const std::string& one : overrides) record += one + '\n';
  return record;
}

}  // namespace creepcontact::study
