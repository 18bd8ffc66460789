#pragma once
/// study.csv and study.md.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/config/study.hpp"
#include "study_results.hpp"

namespace creepcontact::study {

/// One row per run: values of all keys that are varied; errors; start, end, least and largest values of the probes;
/// status, message, costs.
std::string study_csv(const config::Study& study, const std::vector<config::PlannedRun>& runs,
                      const std::vector<StudyRow>& rows);

/// Title, reference, scatter, the same table (its first rows if there are very many), the observed orders along the
/// curves, and the pictures.
/// @param reference  if it is a run @param scatter  scatter_markdown(); empty: no random keys
std::string study_markdown(const config::Study& study, const std::vector<config::PlannedRun>& runs,
                           const std::vector<StudyRow>& rows, const std::optional<StudyRow>& reference,
                           const std::string& scatter, const std::vector<std::filesystem::path>& pictures);

}  // namespace creepcontact::study
