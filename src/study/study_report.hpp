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

/// Title, reference, the same table, the observed orders along the curves, and the pictures.
/// @param reference  if it is a run
std::string study_markdown(const config::Study& study, const std::vector<config::PlannedRun>& runs,
                           const std::vector<StudyRow>& rows, const std::optional<StudyRow>& reference,
                           const std::vector<std::filesystem::path>& pictures);

}  // namespace creepcontact::study
