#pragma once
/// Units of what the runs of a study find.

#include <map>
#include <string>

#include "creepcontact/config/study.hpp"
#include "creepcontact/config/vocabulary.hpp"
#include "creepcontact/study/study.hpp"

namespace creepcontact::study {

/// Empty where a unit is not known.
struct ResultUnits {
  std::string time;
  std::map<std::string, std::string> probes;  ///< by name

  /// "stress (MPa)"
  std::string labelled(const std::string& probe, const std::string& more = "") const;
};

/// Those of the base configuration.
ResultUnits result_units(const config::Study& study, const config::Vocabulary& vocabulary, const StudyOptions& options);

}  // namespace creepcontact::study
