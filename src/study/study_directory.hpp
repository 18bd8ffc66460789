#pragma once
/// The output directory of a study.

#include <filesystem>

#include "creepcontact/study/study.hpp"

namespace creepcontact::study {

std::filesystem::path directory_of(const config::Study& study, const StudyOptions& options);

/// Makes the directory and writes into it which study it holds. Shards do so at the same time.
/// @throws ConfigError if it cannot be made, or holds another study or somebody else's runs
void claim_directory(const std::filesystem::path& directory, const config::Study& study);

}  // namespace creepcontact::study
