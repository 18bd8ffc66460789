#pragma once
/// What a study with random keys found, as its directory tells it.

#include <filesystem>

#include "html.hpp"

namespace creepcontact::report {

/// Whether the directory is that of a study with random keys.
bool has_scatter(const std::filesystem::path& directory);

/// The section "Scatter" of study.md, and the fan charts, probabilities and histograms next to it; nothing if the
/// directory has none. Links are not followed.
void add_scatter(const std::filesystem::path& directory, Html& page);

}  // namespace creepcontact::report
