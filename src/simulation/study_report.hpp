#pragma once
/// study.csv and study.md.

#include <optional>
#include <string>
#include <vector>

#include "creepcontact/config/study.hpp"
#include "creepcontact/simulation/study_results.hpp"

namespace creepcontact::simulation {

/// A row a run: values of the axes, then of the other keys that single runs set; errors; status, message, costs.
std::string study_csv(const config::Study& study, const std::vector<config::PlannedRun>& runs,
                      const std::vector<StudyRow>& rows);

/// Title, reference, the same table, and the observed orders where an axis is a step or a tolerance.
/// @param reference  if it is a run
std::string study_markdown(const config::Study& study, const std::vector<config::PlannedRun>& runs,
                           const std::vector<StudyRow>& rows, const std::optional<StudyRow>& reference);

}  // namespace creepcontact::simulation
